#pragma once

#include <cstdint>
#include <string>
#include <type_traits>

#include <benchmark/benchmark.h>

#include <fairlight/estimators/concepts.h>
#include <fairlight/estimators/stream.h>

namespace fairlight::benchmarks {

constexpr std::uint64_t draws = 1 << 16;
constexpr std::uint64_t a_stream = 4;  // draws from each stream, as a path takes several

/// How many draws a second `draw(source)` gives, its random numbers included; it gives a number or a vector. It may count
/// its draws.
template <class Real, class Draw>
void measure(benchmark::State& state, Draw draw) {
  const StreamKey key(1, "benchmark");
  for (auto _ : state) {
    auto sum = zero<std::invoke_result_t<Draw, PhiloxStream<Real>&>>();
    for (std::uint64_t i = 0; i < draws / a_stream; i += lanes<Real>) {
      PhiloxStream<Real> source(key, 0, i);
      for (std::uint64_t k = 0; k < a_stream; ++k) sum += draw(source);
    }
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(draws));
}

/// In double and in packets, `make(type_identity<Real>)` giving the draw: compare the two rates of one run.
template <class Make>
void compare(const std::string& name, const Make& make) {
  const auto add = [&]<class Real>(std::type_identity<Real> real, const std::string& kind) {
    const auto draw = make(real);
    benchmark::RegisterBenchmark((name + "/" + kind).c_str(),
                                 [draw](benchmark::State& state) { measure<Real>(state, draw); })
        ->Repetitions(5)
        ->ReportAggregatesOnly();
  };
  add(std::type_identity<double>{}, "double");
  add(std::type_identity<Packet>{}, "packet");
}

}  // namespace fairlight::benchmarks
