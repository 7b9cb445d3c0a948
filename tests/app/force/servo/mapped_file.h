// A value in a file that several processes map.
#pragma once

#include <cstdlib>
#include <fstream>
#include <string>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace touchline {

/// Maps the file for as long as the process lives. T consists of atomic numbers that all start at
/// zero.
template <class T>
T& mapped(const std::string& path) {
    const int file = open(path.c_str(), O_RDWR | O_CLOEXEC);
    void* const start = mmap(nullptr, sizeof(T), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (file < 0 || start == MAP_FAILED) std::abort();
    close(file);
    return *static_cast<T*>(start);
}

/// Makes a new value, all zero.
template <class T>
T& make_mapped(const std::string& path) {
    std::ofstream(path, std::ios::binary).write(std::string(sizeof(T), '\0').data(), sizeof(T));
    return mapped<T>(path);
}

}  // namespace touchline
