#pragma once

#include <algorithm>

#include <fairlight/estimators/bsdf.h>

namespace fairlight {

/// One lobe of a mixture.
template <Bsdf Part>
struct WeightedLobe {
  Part bsdf;
  typename Part::Scalar weight;       ///< factor of its f, nonnegative
  typename Part::Scalar probability;  ///< of choosing it; 0 only if the weight is 0
};
template <class Part>
WeightedLobe(Part, typename Part::Scalar, typename Part::Scalar) -> WeightedLobe<Part>;

/// The sum of two BSDFs; each bounce samples one of them. Nest mixtures for more. Each may have a
/// density, or single directions, or both.
/// Formula  f = w_1 f_1 + w_2 f_2, p = q_1 p_1 + q_2 p_2
/// Measure  f in 1/sr; the density in solid angle; 0 for single directions
/// Domain   that of the lobes; w_i >= 0, q_i in [0,1], q_1 + q_2 = 1; w_i = 0 if q_i = 0
/// Random   u_0 in [0,1) chooses the lobe; the lobe takes the following numbers
/// Source   Veach and Guibas 1995 (the one-sample model, balance heuristic)
template <Bsdf First, Bsdf Second>
class Mixture {
  // A bounce is drawn from lobe i with probability q_i. If it has a density, it weighs f |cos| / p.
  // If it is a single direction, it weighs w_i / q_i times its weight in lobe i: the other lobe
  // finds this direction with probability 0, so it adds nothing.
 public:
  using Scalar = typename First::Scalar;
  static constexpr int dimensions = 1 + std::max(First::dimensions, Second::dimensions);

  /// Throws std::invalid_argument for weights or probabilities outside their domain.
  Mixture(const WeightedLobe<First>& first, const WeightedLobe<Second>& second) : first_(first), second_(second) {
    require_lobe(first.weight, first.probability);
    require_lobe(second.weight, second.probability);
    using std::abs;
    if (!all(abs(first.probability + second.probability - Real(1)) <= Real(4 * ulp<Real>))) {
      throw std::invalid_argument("the probabilities of a mixture's lobes must sum to 1 (one of them is chosen)");
    }
  }

  Rgb<Scalar> eval(const Vec3<Scalar>& out, const Vec3<Scalar>& in) const {
    return first_.weight * first_.bsdf.eval(out, in) + second_.weight * second_.bsdf.eval(out, in);
  }

  Density<SolidAngle, Scalar> pdf(const Vec3<Scalar>& out, const Vec3<Scalar>& in) const {
    return Density<SolidAngle, Scalar>(first_.probability * first_.bsdf.pdf(out, in).value() +
                                       second_.probability * second_.bsdf.pdf(out, in).value());
  }

  Rgb<Scalar> albedo(const Vec3<Scalar>& out) const requires requires(const First a, const Second b) {
    a.albedo(out), b.albedo(out);
  }
  { return first_.weight * first_.bsdf.albedo(out) + second_.weight * second_.bsdf.albedo(out); }

  Bounce<Scalar> sample(const Vec3<Scalar>& out, const Eigen::Matrix<Scalar, dimensions, 1>& u) const {
    using std::abs;
    const Mask<Real> takes_first = u[0] < first_.probability;
    const Bounce<Real> a = bounce_of(first_, out, u);
    const Bounce<Real> b = bounce_of(second_, out, u);
    const Vec3<Real> in = select(takes_first, a.in, b.in);
    const Mask<Real> single = select(takes_first, a.density.value(), b.density.value()) == Real(0);
    const Real density = select(single, Real(0), pdf(out, in).value());
    const Rgb<Real> shared = eval(out, in) * (abs(in.z()) / select(single, Real(1), density));
    return {in, select(single, select(takes_first, a.weight, b.weight), shared),
            Density<SolidAngle, Real>(density)};
  }

 private:
  using Real = Scalar;

  /// The lobe's bounce, weighted as if no other lobe could produce it.
  template <class Part>
  static Bounce<Real> bounce_of(const WeightedLobe<Part>& lobe, const Vec3<Real>& out,
                                const Eigen::Matrix<Real, dimensions, 1>& u) {
    Bounce<Real> bounce = lobe.bsdf.sample(out, u.template segment<Part::dimensions>(1));
    bounce.weight *= lobe.weight / select(lobe.probability > Real(0), lobe.probability, Real(1));
    return bounce;
  }

  static void require_lobe(Real weight, Real probability) {
    if (!all_nonnegative(weight)) {
      throw std::invalid_argument("the weight of a mixture's lobe must be nonnegative and finite (light adds up)");
    }
    if (!all_within(probability, 0, 1)) {
      throw std::invalid_argument("the probability of a mixture's lobe must be in [0,1] (it is a probability)");
    }
    if (any(probability == Real(0) && weight > Real(0))) {
      throw std::invalid_argument("a mixture's lobe of probability 0 must have weight 0 (its light would be lost)");
    }
  }

  WeightedLobe<First> first_;
  WeightedLobe<Second> second_;
};

}  // namespace fairlight
