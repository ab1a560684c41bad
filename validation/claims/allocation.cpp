#include <fairlight/estimators/allocation_naive.h>
#include <fairlight/estimators/allocation_unbiased.h>
#include <fairlight/validation/analytic/spiky_pixels.h>
#include <fairlight/validation/claims/claims.h>

namespace fairlight {
namespace {

constexpr PixelGrid eight(4, 2);

template <class Score>
void add_unbiased(std::vector<Claim>& claims, const std::string& by, const std::string& score) {
  claims.push_back(unbiased_allocation("allocation.pilot." + by, {"DiscardedPilot", score}, "Kirk and Arvo 1991",
                                       DiscardedPilot<Score>({eight, 64, 2})));
  claims.push_back(unbiased_allocation("allocation.stages." + by, {"FixedStageWeights", score},
                                       "Owen and Zhou 2020", FixedStageWeights<Score>({eight, 64, 2}, 3)));
  claims.push_back(unbiased_allocation("allocation.halves." + by, {"CrossedHalves", score}, "Cox 1975",
                                       CrossedHalves<Score>({eight, 64, 2})));
}

}  // namespace

void add_allocation_claims(std::vector<Claim>& claims) {
  add_unbiased<UniformAllocation>(claims, "uniform", "UniformAllocation");
  add_unbiased<AllocationByDeviation>(claims, "deviation", "AllocationByDeviation");
  add_unbiased<AllocationByVariance>(claims, "variance", "AllocationByVariance");
  add_unbiased<AllocationByNeighbours>(claims, "neighbours", "AllocationByNeighbours");
  const PooledSpikes closed(equal_spikes_p);
  const naive::PooledStages<AllocationByVariance> history({PixelGrid(2, 2), 20, 2});
  const naive::PooledStages<AllocationByNeighbours> neighbours({PixelGrid(2, 2), 16, 1});
  claims.push_back(pooled_allocation("allocation.naive.history", {"PooledStages", "AllocationByVariance"},
                                     "four spiky pixels have the mean of the closed form, 34 % too dark",
                                     closed.by_history(), Sides::both, history));
  claims.push_back(pooled_allocation("allocation.naive.history.darker", {"PooledStages"}, "at least 30 % too dark",
                                     0.7, Sides::not_above, history));
  claims.push_back(pooled_allocation("allocation.naive.neighbours", {"PooledStages", "AllocationByNeighbours"},
                                     "four spiky pixels have the mean of the closed form, 9 % too dark",
                                     closed.by_neighbours(), Sides::both, neighbours));
  claims.push_back(pooled_allocation("allocation.naive.neighbours.darker", {"PooledStages"},
                                     "at least 7 % too dark", 0.93, Sides::not_above, neighbours));
  const DiscardedPilot<UniformAllocation> uniform({eight, 128, 0});
  claims.push_back(quieter_allocation("allocation.pilot.deviation.quieter",
                                      {"DiscardedPilot", "AllocationByDeviation"}, 0.6,
                                      DiscardedPilot<AllocationByDeviation>({eight, 128, 4}), uniform));
  claims.push_back(quieter_allocation("allocation.halves.deviation.quieter",
                                      {"CrossedHalves", "AllocationByDeviation"}, 0.6,
                                      CrossedHalves<AllocationByDeviation>({eight, 128, 4}), uniform));
}

}  // namespace fairlight
