#include <fairlight/estimators/allocation_naive.h>
#include <fairlight/estimators/allocation_unbiased.h>
#include <fairlight/validation/claims/claims.h>
#include <fairlight/validation/claims/spiky_pixels.h>

namespace fairlight {
namespace {

constexpr PixelGrid eight(4, 2);

constexpr AllocationPlan plan{eight, 64, 2};

template <class Score, class Numbers = FromStreams<>>
Claim pilot_claim(const std::string& by, const std::string& score, const Numbers& numbers = {}) {
  return unbiased_allocation("allocation.pilot." + by, {"DiscardedPilot", score}, "Kirk and Arvo 1991",
                             DiscardedPilot<Score>(plan), numbers);
}
template <class Score, class Numbers = FromStreams<>>
Claim stages_claim(const std::string& by, const std::string& score, const Numbers& numbers = {}) {
  return unbiased_allocation("allocation.stages." + by, {"FixedStageWeights", score}, "Owen and Zhou 2020",
                             FixedStageWeights<Score>(plan, 3), numbers);
}
template <class Score, class Numbers = FromStreams<>>
Claim halves_claim(const std::string& by, const std::string& score, const Numbers& numbers = {}) {
  return unbiased_allocation("allocation.halves." + by, {"CrossedHalves", score}, "Cox 1975",
                             CrossedHalves<Score>(plan), numbers);
}

/// Every form with a score.
template <class Score, class Numbers = FromStreams<>>
void add_forms(std::vector<Claim>& claims, const std::string& by, const std::string& score,
               const Numbers& numbers = {}) {
  claims.push_back(pilot_claim<Score>(by, score, numbers));
  claims.push_back(stages_claim<Score>(by, score, numbers));
  claims.push_back(halves_claim<Score>(by, score, numbers));
}

/// From point sets, each form and each score once: neither depends on where its samples come from.
template <class Numbers>
void add_numbers(std::vector<Claim>& claims, const Numbers& numbers) {
  claims.push_back(pilot_claim<UniformAllocation>("uniform", "UniformAllocation", numbers));
  claims.push_back(pilot_claim<AllocationByNeighbours>("neighbours", "AllocationByNeighbours", numbers));
  claims.push_back(stages_claim<AllocationByVariance>("variance", "AllocationByVariance", numbers));
  claims.push_back(halves_claim<AllocationByDeviation>("deviation", "AllocationByDeviation", numbers));
}

/// Every form where pixels are negative too.
void add_signed(std::vector<Claim>& claims) {
  const SpikyPixels spiky = signed_spikes();
  const auto row = [&](const std::string& form, const std::string& subject, const std::string& source,
                       const std::string& score, const auto& made) {
    return unbiased_allocation("allocation." + form + ".signed", {subject, score}, source, made, FromStreams<>(),
                               spiky);
  };
  claims.push_back(row("pilot", "DiscardedPilot", "Kirk and Arvo 1991", "AllocationByNeighbours",
                       DiscardedPilot<AllocationByNeighbours>(plan)));
  claims.push_back(row("stages", "FixedStageWeights", "Owen and Zhou 2020", "AllocationByVariance",
                       FixedStageWeights<AllocationByVariance>(plan, 3)));
  claims.push_back(row("halves", "CrossedHalves", "Cox 1975", "AllocationByDeviation",
                       CrossedHalves<AllocationByDeviation>(plan)));
}

/// The naive form and its bias. With p <= 1/2, the two points of a pilot never both meet a spike.
void add_naive(std::vector<Claim>& claims) {
  const naive::PooledStages<AllocationByVariance> by_history({PixelGrid(2, 2), 20, 2});
  const naive::PooledStages<AllocationByNeighbours> by_neighbours({PixelGrid(2, 2), 16, 1});
  const std::vector<std::string> history{"PooledStages", "AllocationByVariance"};
  const std::vector<std::string> neighbours{"PooledStages", "AllocationByNeighbours"};
  const double p = equal_spikes_p;
  const auto add = [&](const PooledSpikes& closed, const auto& numbers) {
    claims.push_back(
        pooled_allocation("allocation.naive.history", history, closed.by_history(), by_history, numbers));
    claims.push_back(pooled_allocation("allocation.naive.neighbours", neighbours, closed.by_neighbours(),
                                       by_neighbours, numbers));
  };
  add(PooledSpikes(p, p * p), FromStreams<>());
  for_each_point_set([&](const auto& kind) { add(PooledSpikes(p, 0), FromSets(kind)); });
  claims.push_back(darker_allocation("allocation.naive.history.darker", 0.7, by_history));
  claims.push_back(darker_allocation("allocation.naive.neighbours.darker", 0.93, by_neighbours));
}

}  // namespace

void add_allocation_claims(std::vector<Claim>& claims) {
  add_signed(claims);
  add_forms<UniformAllocation>(claims, "uniform", "UniformAllocation");
  add_forms<AllocationByDeviation>(claims, "deviation", "AllocationByDeviation");
  add_forms<AllocationByVariance>(claims, "variance", "AllocationByVariance");
  add_forms<AllocationByNeighbours>(claims, "neighbours", "AllocationByNeighbours");
  // From packets, each form once, as the scores are computed in double.
  add_forms<AllocationByNeighbours>(claims, "neighbours", "AllocationByNeighbours", FromStreams<Packet>());
  for_each_point_set([&](const auto& kind) { add_numbers(claims, FromSets(kind)); });
  add_naive(claims);
  const DiscardedPilot<UniformAllocation> uniform({eight, 128, 0});
  claims.push_back(quieter_allocation("allocation.pilot.deviation.quieter",
                                      {"DiscardedPilot", "AllocationByDeviation"}, 0.6,
                                      DiscardedPilot<AllocationByDeviation>({eight, 128, 4}), uniform));
  claims.push_back(quieter_allocation("allocation.halves.deviation.quieter",
                                      {"CrossedHalves", "AllocationByDeviation"}, 0.6,
                                      CrossedHalves<AllocationByDeviation>({eight, 128, 4}), uniform));
}

}  // namespace fairlight
