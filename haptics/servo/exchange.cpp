#include "haptics/servo/exchange.h"

#include <utility>

namespace touchline {

void ServoExchange::feel(std::shared_ptr<const Scene> scene) {
    const Offer offer{scene.get(), ++last_serial_};
    kept_.push_back({std::move(scene), offer.serial});
    offers_.write(offer);
    drop_unused_scenes();
}

const ServoReport& ServoExchange::report() {
    drop_unused_scenes();
    reports_.update();
    return reports_.value();
}

const ServoCommands& ServoExchange::commands() {
    commands_.update();
    return commands_.value();
}

const Scene* ServoExchange::wanted_scene() {
    offers_.update();
    return offers_.value().scene;
}

void ServoExchange::release_older_scenes() {
    oldest_used_.store(offers_.value().serial, std::memory_order_release);
}

void ServoExchange::drop_unused_scenes() {
    const std::uint64_t oldest = oldest_used_.load(std::memory_order_acquire);
    while (!kept_.empty() && kept_.front().serial < oldest) kept_.pop_front();
}

}  // namespace touchline
