#pragma once

#include <tuple>

#include <fairlight/estimators/energy_compensation.h>
#include <fairlight/validation/claims/microfacets.h>

namespace fairlight {

/// The largest relative error that the fit of the lost energy gives a mean.
inline constexpr double loss_rounding = 1e-5;

template <class Real, class Loss>
using GreyConductor = EnergyCompensatedConductor<Real, ConstantReflectance<Real>, Loss>;

/// An energy-compensated conductor of grey facets, seen from the height z. A fault can replace its
/// `Loss`.
template <class Loss>
struct GreyMetal {
  double alpha, z, reflectance;

  template <class Real>
  auto surface() const {
    const Rgb<Real> grey = Rgb<Real>::Constant(rounded<Real>(reflectance));
    return GreyConductor<Real, Loss>(alpha, ConstantReflectance<Real>(grey));
  }
  GgxView view() const { return {alpha, alpha, z}; }

  /// The surface in every arithmetic. It fits the loss once, not for each draw.
  auto surfaces() const { return std::tuple(surface<double>(), surface<Packet>()); }
};

/// The mean weight of a bounce. `upper` bounds the weight: the lobes are mixed, so it is at most
/// the larger of theirs, F / E(out) and F (1 - E(in)) / (1 - Eavg).
template <class Loss>
auto metal_weight(const std::string& name, const GreyMetal<Loss>& metal, double albedo, double upper) {
  const auto draw = [surfaces = metal.surfaces(), out = metal.view().out()]<class Real>(std::type_identity<Real>,
                                                                                        auto& source) {
    const auto& surface = std::get<GreyConductor<Real, Loss>>(surfaces);
    const Vec2<Real> place = next_pair<Real>(source);
    return Real(surface.sample(rounded_vector<Real>(out), {place.x(), place.y(), source.next()}).weight[0]);
  };
  return estimand(name, {"EnergyCompensatedConductor", "ConstantReflectance"},
                  "the weight of a bounce has the albedo as its mean; with white facets, 1", "Kulla and Conty 2017",
                  {{.mean = albedo, .lower = 0, .upper = upper, .rounding = loss_rounding}}, draw);
}

/// The white furnace: facets that absorb nothing reflect all the light.
template <class Loss = GgxLoss>
auto metal_furnace(const std::string& name, double alpha, double z, double upper) {
  return metal_weight(name, GreyMetal<Loss>{alpha, z, 1}, 1, upper);
}

/// Grey facets of reflectance F at alpha = 1, where E(z) = 1 - z log(1 + 1/z) and Eavg = 4/3
/// (1 - log 2). A single reflection gives F E. The rest is reflected again, with the reflectance F,
/// and the share Eavg leaves each time.
template <class Loss = GgxLoss>
auto grey_metal(const std::string& name) {
  const GreyMetal<Loss> metal{1, 0.6, 0.5};
  const double f = metal.reflectance;
  const double once = rough_albedo(metal.z);
  const double leaving = rough_mean_albedo();
  const double further = f * f * leaving / (1 - f * (1 - leaving));
  return metal_weight(name, metal, f * once + further * (1 - once), f / once);
}

/// The white furnace by uniform directions: the integral of f cos is 1.
/// Bound    that of the single reflection, as in conductor_uniform, plus 2 pi (1 - E(out))
///          (1 - E(in)) / (pi (1 - Eavg))
template <class Loss = GgxLoss>
auto metal_uniform(const std::string& name) {
  const GreyMetal<Loss> metal{1, 0.6, 1};
  const auto draw = [surfaces = metal.surfaces(), out = metal.view().out()]<class Real>(std::type_identity<Real>,
                                                                                        auto& source) {
    const auto& surface = std::get<GreyConductor<Real, Loss>>(surfaces);
    const Vec3<Real> o = rounded_vector<Real>(out);
    return Importance(UniformHemisphere<Real>{},
                      [&](const Vec3<Real>& in) { return Real(surface.eval(o, in)[0] * in.z()); })
        .estimate(source);
  };
  return estimand(name, {"EnergyCompensatedConductor", "UniformHemisphere"},
                  "the integral of f cos over uniform directions is 1 for white facets", "Kulla and Conty 2017",
                  {{.mean = 1,
                    .lower = 0,
                    .upper = 1 + 2 * (1 - rough_albedo(0.6)) / (1 - rough_mean_albedo()),
                    .rounding = loss_rounding}},
                  draw);
}

}  // namespace fairlight
