#pragma once

#include <fairlight/validation/checks/parameters.h>
#include <fairlight/validation/claims/microfacets.h>
#include <fairlight/validation/claims/reflectances.h>

namespace fairlight {

/// Rough metals whose reflectance depends on the angle and on the channel, seen from three
/// directions: each channel has its own direction, its own reflectance and a bounce of its own. F
/// at another cosine than that at the facet is too bright at grazing angles and too dark at steep
/// ones, so it cannot hide in all three.

/// The ranges of the heights z of the three directions.
inline constexpr std::array<std::array<double, 2>, 3> metal_heights{{{1e-3, 0.1}, {0.1, 0.5}, {0.5, 1}}};

/// Facets, and for each channel the direction `out` and the numbers of its reflectance.
struct ColouredMetal {
  std::array<double, 2> alpha{};
  std::array<Eigen::Vector3d, 3> out{};
  std::array<std::array<double, 3>, 2> numbers{};  ///< [number][channel]

  /// From values in the order of metal_ranges, rounded to floats, which packets hold exactly.
  static ColouredMetal of(const std::vector<double>& values) {
    const auto value = [&](std::size_t i) { return in_floats_exactly(values.at(i)); };
    ColouredMetal metal{.alpha = {value(0), value(1)}};
    const std::size_t each = (values.size() - 2) / 3;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t first = 2 + each * c;
      const double z = value(first);
      const double sine = std::sqrt((1 - z) * (1 + z));
      metal.out[c] = {sine * std::cos(value(first + 1)), sine * std::sin(value(first + 1)), z};
      for (std::size_t i = 2; i < each; ++i) metal.numbers[i - 2][c] = value(first + i);
    }
    return metal;
  }
};

/// The ranges of a metal: of its roughness along both axes, and for each channel those of `out` and
/// of the numbers.
inline std::vector<ParameterRange> metal_ranges(double smoothest, double roughest,
                                                const std::array<std::vector<ParameterRange>, 3>& numbers) {
  constexpr auto logarithmic = ParameterRange::Law::logarithmic;
  std::vector<ParameterRange> ranges;
  for (const char* axis : {"roughness along x", "roughness along y"})
    ranges.push_back({"RoughConductor", axis, smoothest, roughest, logarithmic});
  for (std::size_t c = 0; c < 3; ++c) {
    ranges.push_back({"RoughConductor", "height of out", metal_heights[c][0], metal_heights[c][1], logarithmic});
    ranges.push_back({"RoughConductor", "azimuth of out", 0, 2 * std::numbers::pi});
    ranges.insert(ranges.end(), numbers[c].begin(), numbers[c].end());
  }
  return ranges;
}

/// Schlick's reflectance; its number is that at normal incidence.
struct SchlickMetal {
  static constexpr const char* component = "SchlickReflectance";
  static std::vector<ParameterRange> ranges(double smoothest, double roughest) {
    const auto up_to = [](double high) {
      return std::vector<ParameterRange>{{component, "reflectance", 0.02, high}};
    };
    return metal_ranges(smoothest, roughest, {up_to(0.9), up_to(0.5), up_to(0.2)});
  }
  static double reflectance(double at_normal, double, double cosine) {
    return at_normal + (1 - at_normal) * std::pow(1 - cosine, 5);
  }
  template <class Real>
  static auto of(const Rgb<Real>& at_normal, const Rgb<Real>&) {
    return SchlickReflectance<Real>(at_normal);
  }
};

/// Fresnel's equations; the numbers are eta and k.
struct FresnelMetal {
  static constexpr const char* component = "FresnelReflectance";
  static std::vector<ParameterRange> ranges(double smoothest, double roughest) {
    const std::vector<ParameterRange> index{{component, "eta", 0.1, 4, ParameterRange::Law::logarithmic},
                                            {component, "k", 0, 4}};
    return metal_ranges(smoothest, roughest, {index, index, index});
  }
  static double reflectance(double eta, double k, double cosine) {
    return fresnel_by_amplitudes(std::acos(std::min(cosine, 1.0)), {eta, k});
  }
  template <class Real>
  static auto of(const Rgb<Real>& eta, const Rgb<Real>& k) {
    return FresnelReflectance<Real>(eta, k);
  }
};

/// The surface. A fault can replace it.
template <class Real, class Reflectance>
using PlainMetal = RoughConductor<Real, Reflectance>;

/// The mean weight of a bounce, per channel. `references` are those of metal_albedos, or none.
/// Bound    a weight is F G2/G1 <= 1, and a little more, since the albedo plus its margin may
///          exceed 1
template <class Metal, template <class, class> class Surface>
auto metal_bounces(const std::string& name, const ColouredMetal& metal, const std::vector<Reference>& references) {
  const auto draw = [metal]<class Real>(std::type_identity<Real>, auto& source) {
    const auto colour = [&](std::size_t n) {
      return rounded_colour<Real>({metal.numbers[n][0], metal.numbers[n][1], metal.numbers[n][2]});
    };
    const auto reflectance = Metal::template of<Real>(colour(0), colour(1));
    const Surface<Real, std::remove_const_t<decltype(reflectance)>> surface(
        Ggx<Real>(rounded<Real>(metal.alpha[0]), rounded<Real>(metal.alpha[1])), reflectance);
    Rgb<Real> weight;
    for (int c = 0; c < 3; ++c) {
      const Vec3<Real> out = rounded_vector<Real>(metal.out[static_cast<std::size_t>(c)]);
      weight[c] = surface.sample(out, next_pair<Real>(source)).weight[c];
    }
    return weight;
  };
  return estimand(name, {"RoughConductor", "Ggx", "GgxVisibleNormals", Metal::component},
                  "the weight of a bounce off coloured facets has the albedo as its mean, from three directions",
                  "quadrature over the slopes; Walter et al. 2007", references, draw, 4);
}

/// The albedos, by quadrature.
template <class Metal>
std::vector<Reference> metal_albedos(const ColouredMetal& metal) {
  std::vector<Reference> references;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto reflectance = [&](double cosine) {
      return Metal::reflectance(metal.numbers[0][c], metal.numbers[1][c], cosine);
    };
    references.push_back({GgxAlbedo{metal.alpha[0], metal.alpha[1]}(metal.out[c], reflectance), 0, 1.01});
  }
  return references;
}

/// The row in one arithmetic. The references take some 50 ms, so only its check computes them.
template <class Real, class Metal, template <class, class> class Surface = PlainMetal>
Claim metal_claim(const std::string& name, double smoothest, double roughest) {
  const auto ranges = Metal::ranges(smoothest, roughest);
  const auto make = [name](const std::vector<double>& values) {
    const ColouredMetal metal = ColouredMetal::of(values);
    return metal_bounces<Metal, Surface>(name, metal, metal_albedos<Metal>(metal));
  };
  const auto row = metal_bounces<Metal, Surface>(name, ColouredMetal::of(middles(ranges)), {});
  return mean_claim_over<Real>(ranges, make, row);
}

/// The rows of smooth metals. Fresnel at the normal is right in the limit of smoothness, so a run
/// whose roughnesses are small cannot see it.
template <class Real>
std::vector<Claim> smooth_metal_claims() {
  return {metal_claim<Real, SchlickMetal, PlainMetal>("rough_conductor.schlick.smooth", 1e-4, 0.01),
          metal_claim<Real, SchlickMetal, PlainMetal>("rough_conductor.schlick.glossy", 0.01, 0.2)};
}

/// The rows of rough ones, which faults share.
template <class Real, template <class, class> class Surface = PlainMetal>
std::vector<Claim> rough_metal_claims() {
  return {metal_claim<Real, SchlickMetal, Surface>("rough_conductor.schlick.rough", 0.2, 1),
          metal_claim<Real, FresnelMetal, Surface>("rough_conductor.fresnel", 0.1, 1)};
}

}  // namespace fairlight
