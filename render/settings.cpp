#include <iterator>
#include <limits>
#include <stdexcept>

#include <fairlight/render/settings.h>
#include <fairlight/stats/seed.h>

namespace fairlight {

void SampleLedger::add(std::uint64_t seed, SampleRange range) {
  if (range.first >= range.last) throw std::invalid_argument("a render must hold at least one sample per pixel");
  if (range.last - range.first > std::numeric_limits<std::uint64_t>::max() - total())
    throw std::invalid_argument("a picture cannot hold 2^64 samples a pixel (merge fewer)");
  auto& ranges = ranges_[seed];
  auto after = ranges.lower_bound(range.first);
  const bool overlaps_before = after != ranges.begin() && std::prev(after)->second > range.first;
  const bool overlaps_after = after != ranges.end() && after->first < range.last;
  if (overlaps_before || overlaps_after) {
    throw std::invalid_argument("samples " + std::to_string(range.first) + " to " + std::to_string(range.last - 1) +
                                " of seed " + seed_text(seed) + " would be counted twice (merge each render once)");
  }
  if (after != ranges.end() && after->first == range.last) {
    range.last = after->second;
    after = ranges.erase(after);
  }
  if (after != ranges.begin() && std::prev(after)->second == range.first) {
    std::prev(after)->second = range.last;
  } else {
    ranges[range.first] = range.last;
  }
}

void SampleLedger::merge(const SampleLedger& other) {
  for (const auto& [seed, ranges] : other.ranges_) {
    for (const auto& [first, last] : ranges) add(seed, {first, last});
  }
}

std::uint64_t SampleLedger::total() const {
  std::uint64_t sum = 0;
  for (const auto& [seed, ranges] : ranges_) {
    for (const auto& [first, last] : ranges) sum += last - first;
  }
  return sum;
}

std::uint64_t SampleLedger::next(std::uint64_t seed) const {
  const auto found = ranges_.find(seed);
  return found == ranges_.end() ? 0 : found->second.rbegin()->second;
}

std::uint64_t SampleLedger::seed() const {
  if (ranges_.size() != 1)
    throw std::invalid_argument("the picture holds samples of several seeds (name one by --seed)");
  return ranges_.begin()->first;
}

nlohmann::json SampleLedger::json() const {
  nlohmann::json json = nlohmann::json::object();
  for (const auto& [seed, ranges] : ranges_) {
    for (const auto& [first, last] : ranges) json[seed_text(seed)].push_back({first, last});
  }
  return json;
}

SampleLedger SampleLedger::from_json(const nlohmann::json& json) {
  SampleLedger ledger;
  for (const auto& [seed, ranges] : json.items()) {
    for (const auto& range : ranges) {
      ledger.add(parse_seed(seed), {range.at(0).get<std::uint64_t>(), range.at(1).get<std::uint64_t>()});
    }
  }
  return ledger;
}

}  // namespace fairlight
