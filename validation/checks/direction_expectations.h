#pragma once

#include <algorithm>
#include <array>

#include <fairlight/validation/checks/direction_checks.h>

namespace fairlight {

/// What a light's `sample` returns, seen from a point.
struct LightSampleUnderTest {
  Vec3<double> direction;  ///< unit
  double distance;         ///< to the light, in the caller's unit of length
  double pdf;              ///< of the direction [1/sr]
};

/// The numbers of an adapter that takes an array.
template <std::size_t N>
std::array<double, N> as_array(const std::vector<double>& u) {
  std::array<double, N> numbers;
  std::copy_n(u.begin(), N, numbers.begin());
  return numbers;
}

/// The checks' view of an adapter of a sampler of directions, which must outlive it:
///   static constexpr std::size_t dimensions = 2;
///   std::optional<DirectionSample> sample(const std::array<double, 2>& u) const;
///   double pdf(const Vec3<double>& direction) const;  // [1/sr]
template <class Adapter>
DirectionsUnderTest directions_of(const Adapter& sampler) {
  return {Adapter::dimensions,
          [&sampler](const std::vector<double>& u) -> std::optional<DirectionSample> {
            return sampler.sample(as_array<Adapter::dimensions>(u));
          },
          [&sampler](const Vec3<double>& direction) -> double { return sampler.pdf(direction); }};
}

/// The sampled directions to a light from a point. The adapter has
///   std::optional<LightSampleUnderTest> sample(const Vec3<double>& from, const std::array<double, 2>& u) const;
///   double pdf(const Vec3<double>& from, const Vec3<double>& direction) const;  // [1/sr]
template <class Adapter>
DirectionsUnderTest directions_to(const Adapter& light, const Vec3<double>& from) {
  return {Adapter::dimensions,
          [&light, from](const std::vector<double>& u) -> std::optional<DirectionSample> {
            const std::optional<LightSampleUnderTest> sample = light.sample(from, as_array<Adapter::dimensions>(u));
            if (!sample) return {};
            return DirectionSample{sample->direction, sample->pdf};
          },
          [&light, from](const Vec3<double>& direction) -> double { return light.pdf(from, direction); }};
}

/// The distance of a sample, and that at which a ray in its direction meets the light; none where it
/// does not.
using DistancesOfLight = std::function<std::optional<std::array<double, 2>>(const std::vector<double>& u)>;

/// Those of an adapter, which also has
///   double hit(const Vec3<double>& from, const Vec3<double>& direction) const;  // 0: no hit
template <class Adapter>
DistancesOfLight distances_to(const Adapter& light, const Vec3<double>& from) {
  return [&light, from](const std::vector<double>& u) -> std::optional<std::array<double, 2>> {
    const std::optional<LightSampleUnderTest> sample = light.sample(from, as_array<Adapter::dimensions>(u));
    if (!sample) return {};
    return std::array<double, 2>{sample->distance, light.hit(from, sample->direction)};
  };
}

/// A phase function, seen from a direction. The adapter has
///   std::optional<DirectionSample> sample(const Vec3<double>& out, const std::array<double, 2>& u) const;
///   double pdf(const Vec3<double>& out, const Vec3<double>& in) const;  // [1/sr], which is its value
struct PhaseFunctionUnderTest {
  std::size_t dimensions;
  std::function<std::optional<DirectionSample>(const Vec3<double>& out, const std::vector<double>& u)> sample;
  std::function<double(const Vec3<double>& out, const Vec3<double>& in)> pdf;
};

template <class Adapter>
PhaseFunctionUnderTest phase_function_of(const Adapter& phase) {
  return {Adapter::dimensions,
          [&phase](const Vec3<double>& out, const std::vector<double>& u) -> std::optional<DirectionSample> {
            return phase.sample(out, as_array<Adapter::dimensions>(u));
          },
          [&phase](const Vec3<double>& out, const Vec3<double>& in) -> double { return phase.pdf(out, in); }};
}

/// Expects what check_directions tests. Throws what that and trial_at do.
Expectation expect_directions(const Site& site, const DirectionsUnderTest& law, const DirectionTerms& terms = {});

/// Expects the same of a light's directions, and that a ray in a sampled direction meets the light at
/// the sample's distance.
Expectation expect_light(const Site& site, const DirectionsUnderTest& law, const DistancesOfLight& distances,
                         const DirectionTerms& terms = {});

/// Expects the same of a phase function, seen from three directions drawn anew, and that it is the
/// same with both directions exchanged.
Expectation expect_phase_function(const Site& site, const PhaseFunctionUnderTest& phase,
                                  const DirectionTerms& terms = {});

}  // namespace fairlight
