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

/// Every form with every score.
template <class Score>
void add_unbiased(std::vector<Claim>& claims, const std::string& by, const std::string& score) {
  claims.push_back(pilot_claim<Score>(by, score));
  claims.push_back(stages_claim<Score>(by, score));
  claims.push_back(halves_claim<Score>(by, score));
}

/// From point sets, each form and each score once: neither depends on where its samples come from.
template <class Numbers>
void add_numbers(std::vector<Claim>& claims, const Numbers& numbers) {
  claims.push_back(pilot_claim<UniformAllocation>("uniform", "UniformAllocation", numbers));
  claims.push_back(pilot_claim<AllocationByNeighbours>("neighbours", "AllocationByNeighbours", numbers));
  claims.push_back(stages_claim<AllocationByVariance>("variance", "AllocationByVariance", numbers));
  claims.push_back(halves_claim<AllocationByDeviation>("deviation", "AllocationByDeviation", numbers));
}

/// From packets, each form once, as the scores are computed in double.
void add_packets(std::vector<Claim>& claims) {
  const FromStreams<Packet> packets;
  claims.push_back(pilot_claim<AllocationByNeighbours>("neighbours", "AllocationByNeighbours", packets));
  claims.push_back(stages_claim<AllocationByNeighbours>("neighbours", "AllocationByNeighbours", packets));
  claims.push_back(halves_claim<AllocationByNeighbours>("neighbours", "AllocationByNeighbours", packets));
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
  add(PooledSpikes(p, 0), FromSets(sobol_points()));
  add(PooledSpikes(p, 0), FromSets(stratified_points()));
  add(PooledSpikes(p, 0), FromSets(latin_points()));
  claims.push_back(darker_allocation("allocation.naive.history.darker", 0.7, by_history));
  claims.push_back(darker_allocation("allocation.naive.neighbours.darker", 0.93, by_neighbours));
}

}  // namespace

void add_allocation_claims(std::vector<Claim>& claims) {
  add_unbiased<UniformAllocation>(claims, "uniform", "UniformAllocation");
  add_unbiased<AllocationByDeviation>(claims, "deviation", "AllocationByDeviation");
  add_unbiased<AllocationByVariance>(claims, "variance", "AllocationByVariance");
  add_unbiased<AllocationByNeighbours>(claims, "neighbours", "AllocationByNeighbours");
  add_packets(claims);
  add_numbers(claims, FromSets(sobol_points()));
  add_numbers(claims, FromSets(stratified_points()));
  add_numbers(claims, FromSets(latin_points()));
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
