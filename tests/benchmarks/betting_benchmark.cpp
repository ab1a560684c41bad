// What the core test adds to a loop that sums the same draws: compare the two times of one run.
#include <algorithm>
#include <cmath>
#include <vector>

#include <benchmark/benchmark.h>

#include <fairlight/estimators/stream.h>
#include <fairlight/stats/betting_test.h>

namespace {

using namespace fairlight;

constexpr std::uint64_t draws = 100'000'000;

// Exponential draws, as cheap as an estimator gets: one uniform number and a logarithm.
double draw(const StreamKey& key, std::uint64_t i) { return -std::log1p(-PhiloxStream<double>(key, 0, i).next()); }

void sum_the_draws(benchmark::State& state) {
  const StreamKey key(1, "benchmark");
  for (auto _ : state) {
    double sum = 0;
    for (std::uint64_t i = 0; i < draws; ++i) sum += draw(key, i);
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(draws));
}

void test_the_draws(benchmark::State& state) {
  const StreamKey key(1, "benchmark");
  for (auto _ : state) {
    // A margin so fine, and levels so strict, that no verdict comes before the last draw.
    BettingTest test({1, 1e-5, 0, 40, 1e-9}, 1e-300, 1e-300);
    std::vector<double> block;
    for (std::uint64_t i = 0; i < draws;) {
      block.resize(std::min(test.block_size(), draws - i));
      for (double& x : block) x = draw(key, i++);
      test.add(block);
    }
    benchmark::DoNotOptimize(test.verdict());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(draws));
}

BENCHMARK(sum_the_draws)->Unit(benchmark::kMillisecond)->Repetitions(3)->ReportAggregatesOnly();
BENCHMARK(test_the_draws)->Unit(benchmark::kMillisecond)->Repetitions(3)->ReportAggregatesOnly();

}  // namespace

BENCHMARK_MAIN();
