#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <fairlight/validation/checks/bsdf_checks.h>

/// BSDFs that do not come from the kit, written as other renderers write them, with the errors that
/// some of those shipped. Directions are local, and z is the cosine.
namespace fairlight::testing {

using V = Vec3<double>;
constexpr double pi_ = std::numbers::pi;
using U2 = std::array<double, 2>;

inline V polar(double z, double turn) {
  const double r = std::sqrt(std::max(0.0, 1 - z * z));
  return {r * std::cos(2 * pi_ * turn), r * std::sin(2 * pi_ * turn), z};
}

/// Lambert, seen from both sides.
struct Diffuse {
  static constexpr std::size_t dimensions = 2;
  double albedo = 0.7;
  bool same_side(const V& a, const V& b) const { return a.z() * b.z() > 0; }
  Rgb<double> eval(const V& out, const V& in) const {
    return Rgb<double>::Constant(same_side(out, in) ? albedo / pi_ : 0);
  }
  double pdf(const V& out, const V& in) const { return same_side(out, in) ? std::abs(in.z()) / pi_ : 0; }
  V direction(const V& out, const U2& u) const {
    V in = polar(std::sqrt(1 - u[0]), u[1]);
    if (out.z() < 0) in.z() = -in.z();
    return in;
  }
  std::optional<BsdfSample> sample(const V& out, const U2& u) const {
    return BsdfSample{direction(out, u), Rgb<double>::Constant(albedo), pdf(out, direction(out, u))};
  }
};

/// A base for BSDFs of `Self` that sample a direction, and take weight and pdf from eval and pdf.
template <class Self>
struct BySampling {
  static constexpr std::size_t dimensions = 2;
  std::optional<BsdfSample> sample(const V& out, const U2& u) const {
    const Self& self = static_cast<const Self&>(*this);
    const std::optional<V> in = self.direction(out, u);
    if (!in) return {};
    const double p = self.pdf(out, *in);
    if (!(p > 0)) return {};
    return BsdfSample{*in, self.eval(out, *in) * std::abs(in->z()) / p, p};
  }
};

/// Walter's GGX by half vectors, D cos sampled, seen from both sides, of `roughness`; F is Schlick's.
/// What the derived ones get wrong: `alpha_of_pdf`, `jacobian`, `facing`.
template <class Self>
struct HalfVector : BySampling<Self> {
  double roughness = 0.3;
  const Self& self() const { return static_cast<const Self&>(*this); }

  static double d(double z, double a) {
    const double t = z * z * (a * a - 1) + 1;
    return a * a / (pi_ * t * t);
  }
  static double lambda_plus(double z, double a) {
    return (1 + std::sqrt(1 + a * a * (1 / (z * z) - 1))) / 2;  // 1 + Lambda
  }
  double alpha_of_pdf() const { return roughness; }
  double jacobian(double out_half) const { return 1 / (4 * out_half); }
  double fresnel(double cosine) const { return 0.5 + 0.5 * std::pow(1 - cosine, 5); }
  double scale() const { return 1; }

  Rgb<double> eval(const V& out, const V& in) const {
    if (out.z() * in.z() <= 0) return Rgb<double>::Zero();
    const V half = (out + in).normalized();
    const double o = std::abs(out.z()), i = std::abs(in.z());
    const double g = 1 / (lambda_plus(o, roughness) + lambda_plus(i, roughness) - 1);
    return Rgb<double>::Constant(self().scale() * d(half.z(), roughness) * g * self().fresnel(out.dot(half)) /
                                 (4 * o * i));
  }
  double pdf(const V& out, const V& in) const {
    if (out.z() * in.z() <= 0) return 0;
    const V half = (out + in).normalized();
    return d(half.z(), self().alpha_of_pdf()) * std::abs(half.z()) * self().jacobian(out.dot(half));
  }
  std::optional<V> direction(const V& out, const U2& u) const {
    const double z = std::sqrt((1 - u[0]) / (1 + (roughness * roughness - 1) * u[0]));
    V half = polar(z, u[1]);
    if (out.z() < 0) half = -half;
    const V in = 2 * out.dot(half) * half - out;
    if (out.dot(half) <= 0 || in.z() * out.z() <= 0) return {};
    return in;
  }
};
struct Ggx3 : HalfVector<Ggx3> {};

/// Half diffuse, half glossy (GGX), a lobe chosen at evens.
template <class Self>
struct TwoLobes : BySampling<Self> {
  Diffuse diffuse{0.4};
  Ggx3 metal{};
  const Self& self() const { return static_cast<const Self&>(*this); }
  Rgb<double> eval(const V& out, const V& in) const { return diffuse.eval(out, in) + 0.5 * metal.eval(out, in); }
  double pdf(const V& out, const V& in) const { return (diffuse.pdf(out, in) + metal.pdf(out, in)) / 2; }
  std::optional<V> direction(const V& out, const U2& u) const {
    if (u[0] < 0.5) return diffuse.direction(out, {2 * u[0], u[1]});
    return metal.direction(out, {2 * u[0] - 1, u[1]});
  }
};
struct Plastic : TwoLobes<Plastic> {};

/// A mirror that returns 0.9 of the light.
struct Silver {
  static constexpr std::size_t dimensions = 1;
  Rgb<double> eval(const V&, const V&) const { return Rgb<double>::Zero(); }
  double pdf(const V&, const V&) const { return 0; }
  std::optional<BsdfSample> sample(const V& out, const std::array<double, 1>&) const {
    return BsdfSample{{-out.x(), -out.y(), out.z()}, Rgb<double>::Constant(0.9), 0};
  }
};

/// A lobe about the mirror direction in floats: f = (n + 2) / (2 pi) cos^n, sampled by its cosine.
struct FloatPhong : BySampling<FloatPhong> {
  float exponent = 33.5f;
  float cosine(const V& out, const V& in) const {
    const Eigen::Vector3f a = out.cast<float>(), b = in.cast<float>();
    return std::max(0.0f, a.z() * b.z() - a.x() * b.x() - a.y() * b.y());
  }
  Rgb<double> eval(const V& out, const V& in) const {
    if (out.z() * in.z() <= 0) return Rgb<double>::Zero();
    return Rgb<double>::Constant(0.6f * (exponent + 2) / (2 * float(pi_)) * std::pow(cosine(out, in), exponent));
  }
  double pdf(const V& out, const V& in) const {
    if (out.z() * in.z() <= 0) return 0;
    return (exponent + 1) / (2 * float(pi_)) * std::pow(cosine(out, in), exponent);
  }
  std::optional<V> direction(const V& out, const U2& u) const {
    const float z = std::pow(1 - float(u[0]), 1 / (exponent + 1)), r = std::sqrt(std::max(0.0f, 1 - z * z));
    const V mirror(-out.x(), -out.y(), out.z());
    const V x = (std::abs(mirror.x()) < 0.5 ? V::UnitX() : V::UnitY()).cross(mirror).normalized();
    const V y = mirror.cross(x);
    const float turn = 2 * float(pi_) * float(u[1]);
    const V in = (r * std::cos(turn)) * x + (r * std::sin(turn)) * y + double(z) * mirror;
    if (in.z() * out.z() <= 0) return {};
    return V(in.normalized());
  }
};

// Twelve errors on record.

/// The density of `out` for `in`.
struct SwappedArguments : TwoLobes<SwappedArguments> {
  double pdf(const V& out, const V& in) const { return TwoLobes::pdf(in, out); }
};
/// The density is that of the diffuse lobe alone.
struct PdfOfTheOtherLobe : TwoLobes<PdfOfTheOtherLobe> {
  double pdf(const V& out, const V& in) const { return diffuse.pdf(out, in); }
};
/// A sheet of paper: half of the light goes through, and no sample does.
struct LobeNotSampled : Diffuse {
  Rgb<double> eval(const V&, const V&) const { return Rgb<double>::Constant(albedo / 2 / pi_); }
  std::optional<BsdfSample> sample(const V& out, const U2& u) const {
    std::optional<BsdfSample> made = Diffuse::sample(out, u);
    made->weight /= 2;
    return made;
  }
};
/// 1 / 4 for 1 / (4 out.half).
struct JacobianForgotten : HalfVector<JacobianForgotten> {
  double jacobian(double) const { return 0.25; }
};
/// f holds the cosine already, so it counts twice.
struct CosineTwice : Diffuse {
  Rgb<double> eval(const V& out, const V& in) const { return Diffuse::eval(out, in) * std::abs(in.z()); }
};
/// Samples above the surface whatever the side of the viewer.
struct OneSideSampled : Diffuse {
  std::optional<BsdfSample> sample(const V&, const U2& u) const {
    const V in = direction(V(0, 0, 1), u);
    return BsdfSample{in, Rgb<double>::Constant(albedo), std::abs(in.z()) / pi_};
  }
};
/// F at the cosine of one direction and not of the facet.
struct FresnelOfTheWrongSide : HalfVector<FresnelOfTheWrongSide> {
  Rgb<double> eval(const V& out, const V& in) const {
    const V half = (out + in).normalized();
    const Rgb<double> f = HalfVector::eval(out, in);
    return f / fresnel(std::abs(out.dot(half))) * fresnel(std::abs(in.z()));
  }
};
/// A white surface that returns 2 % more than it gets.
struct NormalisedByTwoPercentTooMuch : Diffuse {
  NormalisedByTwoPercentTooMuch() : Diffuse{1.02} {}
};
/// The mirror's direction has a density.
struct MirrorWithADensity : Silver {
  double pdf(const V& out, const V& in) const {
    return (V(-out.x(), -out.y(), out.z()) - in).norm() < 1e-4 ? 1 : 0;
  }
};
/// The masking of a grazing direction divides 0 by 0: in floats, z^2 is 0.
struct NanAtGrazing : HalfVector<NanAtGrazing> {
  Rgb<double> eval(const V& out, const V& in) const {
    const float z = static_cast<float>(std::abs(out.z())) < 2e-4f ? 0.0f : 1.0f;
    return HalfVector::eval(out, in) * static_cast<double>(z / z);
  }
};
/// The weight is f cos, not divided by the density.
struct WeightWithoutPdf : Diffuse {
  std::optional<BsdfSample> sample(const V& out, const U2& u) const {
    std::optional<BsdfSample> made = Diffuse::sample(out, u);
    made->weight *= made->pdf;
    return made;
  }
};
/// The density squares a roughness that is squared already.
struct RoughnessSquaredTwice : HalfVector<RoughnessSquaredTwice> {
  double alpha_of_pdf() const { return roughness * roughness; }
};

}  // namespace fairlight::testing
