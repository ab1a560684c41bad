#pragma once

#include <fairlight/estimators/dielectric.h>
#include <fairlight/estimators/mixture.h>

/// Wrong variants of the surfaces.
namespace fairlight::faults {

/// Leaves out the factor 1 / eta^2 of radiance at refraction.
/// On record: caramel #36.
template <class Real>
using UnscaledDielectric = Dielectric<Real, Transport::importance>;

/// Misses total internal reflection: it uses the index for light from outside on both sides, and
/// loses the light where there is then no refracted ray.
/// On record: yocto-gl #452, ChameleonRT #3.
template <class Real>
class LeakyDielectric : public Dielectric<Real> {
 public:
  explicit LeakyDielectric(Real index) : Dielectric<Real>(index), index_(index) {}

  Bounce<Real> sample(const Vec3<Real>& out, const Eigen::Matrix<Real, 1, 1>& u) const {
    using std::abs;
    const Real cosine = abs(out.z());
    const Real eta = this->eta(out);
    const Mask<Real> reflects = u[0] < fresnel_dielectric(cosine, index_);
    const Real passed =
        select(detail::refracted_square(cosine, eta) > Real(0), Real(Real(1) / (eta * eta)), Real(0));
    return {select(reflects, mirrored(out), Vec3<Real>(-out)),
            Rgb<Real>::Constant(select(reflects, Real(1), passed)), Density<SolidAngle, Real>(Real(0))};
  }

 private:
  Real index_;
};

/// A mixture that keeps its lobes, for faults that multiply the weight of a bounce by a wrong
/// factor.
template <class First, class Second>
class WrongMixture : public Mixture<First, Second> {
 public:
  using Real = typename First::Scalar;
  using Numbers = Eigen::Matrix<Real, Mixture<First, Second>::dimensions, 1>;

  WrongMixture(const WeightedLobe<First>& first, const WeightedLobe<Second>& second)
      : Mixture<First, Second>(first, second), first_(first), second_(second) {}

 protected:
  Real first_probability() const { return first_.probability; }

  /// The value of `of` for the chosen lobe.
  template <class Of>
  Real of_chosen(const Numbers& u, const Of& of) const {
    return select(u[0] < first_.probability, Real(of(first_)), Real(of(second_)));
  }

 private:
  WeightedLobe<First> first_;
  WeightedLobe<Second> second_;
};

/// Divides the f of both lobes by the density of the chosen lobe alone: light that both lobes can
/// send counts twice.
/// On record: OpenShadingLanguage #2054.
template <class First, class Second>
struct OwnDensityMixture : WrongMixture<First, Second> {
  using Wrong = WrongMixture<First, Second>;
  using Real = typename Wrong::Real;
  using Wrong::Wrong;

  Bounce<Real> sample(const Vec3<Real>& out, const typename Wrong::Numbers& u) const {
    Bounce<Real> bounce = Wrong::sample(out, u);
    const Real own = this->of_chosen(
        u, [&](const auto& lobe) { return lobe.probability * lobe.bsdf.pdf(out, bounce.in).value(); });
    bounce.weight *= select(own > Real(0), Real(bounce.density.value() / detail::divisor(own)), Real(1));
    return bounce;
  }
};

/// Does not divide the weight of a single direction by the probability of its lobe.
/// On record: the class of mitsuba3 bcc10a142.
template <class First, class Second>
struct UnpaidMixture : WrongMixture<First, Second> {
  using Wrong = WrongMixture<First, Second>;
  using Real = typename Wrong::Real;
  using Wrong::Wrong;

  Bounce<Real> sample(const Vec3<Real>& out, const typename Wrong::Numbers& u) const {
    Bounce<Real> bounce = Wrong::sample(out, u);
    const Real probability = this->of_chosen(u, [](const auto& lobe) { return lobe.probability; });
    bounce.weight *= select(bounce.density.value() > Real(0), Real(1), probability);
    return bounce;
  }
};

/// Rescales the number that chose a lobe by multiplying with its probability instead of dividing.
/// On record: pbrt-v4 795c619b.
template <class First, class Second>
struct NumberReusedWrongly : WrongMixture<First, Second> {
  using Wrong = WrongMixture<First, Second>;
  using Real = typename Wrong::Real;
  using Wrong::Wrong;

  Bounce<Real> sample(const Vec3<Real>& out, const typename Wrong::Numbers& u) const {
    const Real probability = this->of_chosen(u, [](const auto& lobe) { return lobe.probability; });
    const Mask<Real> second = probability != this->first_probability();
    typename Wrong::Numbers reused = u;
    reused[1] = (u[0] - select(second, this->first_probability(), Real(0))) * probability;
    return Wrong::sample(out, reused);
  }
};

/// Applies the cosine twice: in f and in the weight.
/// On record: the class of mitsuba3 #1011.
template <class First, class Second>
struct CosineTwice : WrongMixture<First, Second> {
  using Wrong = WrongMixture<First, Second>;
  using Real = typename Wrong::Real;
  using Wrong::Wrong;

  Bounce<Real> sample(const Vec3<Real>& out, const typename Wrong::Numbers& u) const {
    Bounce<Real> bounce = Wrong::sample(out, u);
    bounce.weight *= bounce.in.z();
    return bounce;
  }
};

}  // namespace fairlight::faults
