#pragma once

#include <fairlight/estimators/padded_sobol.h>
#include <fairlight/estimators/padded_strata.h>
#include <fairlight/render/path_tracer.h>
#include <fairlight/validation/checks/estimand.h>

namespace fairlight {

/// The numbers of a path's vertices as a PointSet, so that the claims of point sets apply. A
/// replicate is the set of a pixel, with three sets for each pixel. Pairs of dimensions come from
/// two blocks of each vertex.
template <class Real, class Numbers>
class PaddedSet {
 public:
  using Scalar = Real;

  PaddedSet(const StreamKey& key, std::uint32_t replicate, std::uint32_t n)
      : numbers_(key, n), replicate_(replicate), n_(n) {}

  std::uint32_t size() const { return n_; }
  VertexSource<Real, Numbers> source(std::uint32_t first) const {
    return {numbers_, vertex(point_numbers<Real>(first, n_), 0)};
  }
  std::array<Real, 2> pair(const Word<Real>& points, std::uint32_t k) const {
    const SampleBlock<Real> block = numbers_.template block<Real>(vertex(points, k / 4), k / 2 % 2);
    return {block[2 * (k % 2)], block[2 * (k % 2) + 1]};
  }

 private:
  PathVertex<Real> vertex(const Word<Real>& points, std::uint32_t number) const {
    using W = Word<Real>;
    return {W(replicate_ / 3), points + W(replicate_ % 3 * n_), W(number)};
  }

  Numbers numbers_;
  std::uint32_t replicate_, n_;
};

template <class Real>
using PaddedSobolSet = PaddedSet<Real, PaddedSobol>;
template <class Real>
using PaddedStrataSet = PaddedSet<Real, PaddedStrata>;

inline PointSetKind<PaddedSobolSet> padded_sobol_points() {
  return {"padded_sobol", "PaddedSobol", "VertexSource"};
}
inline PointSetKind<PaddedStrataSet> padded_strata_points() {
  return {"padded_strata", "PaddedStrata", "VertexSource"};
}

/// The numbers of a path, a sample in each lane: `at(v)` is the source of vertex v.
template <class Real, class Numbers>
struct PathNumbers {
  VertexSource<Real, Numbers> at(std::uint32_t vertex) const {
    return {numbers, {pixel, sample, Word<Real>(vertex)}};
  }
  const Numbers& numbers;
  Word<Real> pixel, sample;
};

/// The radiance of a path, traced vertex by vertex from 1 on. The caller has already used the
/// numbers of vertex 0.
template <class Real, class Tracer, class Numbers>
Rgb<Real> followed(const Tracer& tracer, const auto& scene, Path<Real> path, const Numbers& numbers) {
  Mask<Real> alive(true);
  for (std::uint32_t vertex = 1; any(alive); ++vertex) {
    auto source = numbers.at(vertex);
    alive = tracer.advance(scene, path, source, alive);
  }
  return path.radiance;
}

/// Tests the mean of an estimator that walks along a path, `draw(path)`. A draw of the test is the
/// mean over a whole set of n points: one set in each lane, 1024 sets for each pixel.
template <class Real, class Numbers, class Draw>
Finding check_sets(const Trial& trial, const std::vector<Reference>& references, std::uint32_t n,
                   const Draw& draw) {
  using W = Word<Real>;
  const Numbers numbers(StreamKey(trial.seed, trial.claim), n);
  const auto means = [&](std::uint64_t first) {
    const W sets = W(static_cast<std::uint32_t>(first)) + point_numbers<Real>(0, 1024);
    Real sum(0);
    for (std::uint32_t i = 0; i < n; ++i) {
      sum += draw(PathNumbers<Real, Numbers>{numbers, sets >> 10, (sets & W(1023u)) * W(n) + W(i)});
    }
    return Real(sum / Real(static_cast<Lane<Real>>(n)));
  };
  return test_means(trial, rounded_references<Real>(references),
                    draws_at_once(lanes<Real>, references.size(), [&](std::uint64_t first, const auto& places) {
                      number_in_key(first + lanes<Real> - 1, "sets");
                      store_lanes(means(first), places[0]);
                    }));
}

/// The row that tests the integral of x0 x1 x2 x3 over the unit cube, which is 1/16. The draw takes
/// a pair and a single number at one vertex, and a single number at the next.
template <class Real, class Numbers>
Claim vertices_claim(const std::string& kind, std::vector<std::string> subjects, std::uint32_t n = 16) {
  subjects.emplace_back("VertexSource");
  return {.name = kind + ".vertices" + real_suffix<Real>(),
          .kind = "mean",
          .subjects = std::move(subjects),
          .statement = "the integral of x0 x1 x2 x3 over the cube is 1/16, over sets of " + std::to_string(n) +
                       " samples, with numbers of a pair, a single one and one of another vertex",
          .source = "elementary",
          .margin_factor = 5,
          .check =
              [n](const Trial& trial) {
                return check_sets<Real, Numbers>(trial, {{1.0 / 16, 0, 1}}, n, [](const auto& path) {
                  auto here = path.at(1);
                  auto there = path.at(2);
                  const Vec2<Real> pair = next_pair<Real>(here);
                  return Real(pair.x() * pair.y() * here.next() * there.next());
                });
              },
          .real = real_name<Real>()};
}

}  // namespace fairlight
