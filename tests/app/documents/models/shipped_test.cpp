// Tests that the shipped networks answer on this OpenCV as they did when recorded. After an
// intended change: build/release/tests/app/documents/models/record_outputs >
// tests/app/documents/models/shipped_outputs.csv
#include "tests/app/documents/models/shipped_outputs.h"

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline::testing {
namespace {

constexpr double most_apart = 1e-3;  // share of an output's greatest number

/// Returns the numbers of each row by its name, which is its first three words.
std::map<std::string, std::vector<double>> recorded() {
    std::ifstream file(TOUCHLINE_SOURCE_DIR "/tests/app/documents/models/shipped_outputs.csv");
    std::map<std::string, std::vector<double>> rows;
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string network;
        std::string picture;
        std::string shape;
        std::getline(words, network, ',');
        std::getline(words, picture, ',');
        std::getline(words, shape, ',');
        auto& numbers = rows[network + "," + picture + "," + shape];
        for (std::string number; std::getline(words, number, ',');)
            numbers.push_back(std::stod(number));
    }
    return rows;
}

TEST(ShippedNetworks, AnswerAsRecorded) {
    const auto wanted = recorded();
    const auto rows = shipped_outputs();
    ASSERT_EQ(rows.size(), wanted.size());
    for (const OutputRow& row : rows) {
        ASSERT_TRUE(wanted.contains(row.name)) << row.name;
        const std::vector<double>& numbers = wanted.at(row.name);
        ASSERT_EQ(row.numbers.size(), numbers.size()) << row.name;
        for (std::size_t i = 0; i < numbers.size(); ++i)
            EXPECT_NEAR(row.numbers[i], numbers[i], most_apart * std::abs(numbers.front()))
                << row.name << ", number " << i;
    }
}

}  // namespace
}  // namespace touchline::testing
