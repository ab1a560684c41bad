#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include <fairlight/render/path_tracer.h>
#include <fairlight/validation/faults/wrong_components.h>

namespace fairlight {

/// The biases of Montelight, the paper's renderer, each of which can be on or off.
/// On record: Smerity/montelight-cpp, montelight.cc
struct MontelightFaults {
  bool theta = false;        ///< points of a sphere have a uniform polar angle about the z axis
  bool solid_angle = false;  ///< a shadow ray counts the cone of a sphere of 1.5 m, whatever it was drawn by
  bool roulette = false;     ///< survivors are not divided by their probability
  bool clamped = false;      ///< samples are cut at 1 before they are averaged
};

/// Directions to points of the whole of a spherical light, in double. Rightly: uniform points, with their
/// density per solid angle; those on its far side do not exist.
class MontelightPoints : public PointsBy<SphereByArea> {
 public:
  MontelightPoints(const MontelightFaults& faults, const Scene& scene)
      : faults_(faults), spheres_(scene.luminaires()) {}

  LightSample<double> sample(const LightTable<double>&, int light, bool, const Vec3<double>& from,
                             const Vec2<double>& u) const {
    const Luminaire& sphere = spheres_[static_cast<std::size_t>(light)];
    const UniformSphereArea<double> points(sphere.radius);
    const faults::ThetaUniformSphere<double> crowded(sphere.radius);
    const Vec3<double> normal = faults_.theta ? crowded.sample(u) : points.sample(u);
    const Vec3<double> way = sphere.centre + sphere.radius * normal - from;
    const double distance = way.norm();
    const Vec3<double> direction = way / distance;
    if (faults_.solid_angle) return {direction, distance, Density<SolidAngle, double>(1 / cone_of_1_5_m(distance))};
    const double cosine = -direction.dot(normal);
    if (!(cosine > 0)) return {direction, distance, Density<SolidAngle, double>(0)};
    return {direction, distance, to_solid_angle(points.pdf(normal), distance, cosine)};
  }

 private:
  static double cone_of_1_5_m(double distance) {
    return 2 * std::numbers::pi * (1 - std::sqrt(1 - 2.25 / (distance * distance)));
  }

  MontelightFaults faults_;
  std::vector<Luminaire> spheres_;
};

/// Roulette by the surface's reflectance, from the fifth bounce on as in Montelight.
class MontelightRoulette {
 public:
  explicit MontelightRoulette(const MontelightFaults& faults) : unpaid_(faults.roulette) {}

  template <class Real, class Source>
  Survival<Real> play(const Rgb<Real>& albedo, const Rgb<Real>& throughput, const Real& depth,
                      Source& source) const {
    if (depth < Real(4)) return NoRoulette::play<Real>(albedo, throughput, depth, source);
    return unpaid_ ? RouletteByReflectance<faults::UnpaidRoulette>::play<Real>(albedo, throughput, depth, source)
                   : RouletteByReflectance<>::play<Real>(albedo, throughput, depth, source);
  }

 private:
  bool unpaid_;
};

using MontelightTracer =
    PathTracer<BouncesBy<CosineHemisphere>, DirectLight<AllLights, MontelightPoints>, MontelightRoulette>;

inline MontelightTracer montelight_tracer(const MontelightFaults& faults, const Scene& scene) {
  const DirectLight<AllLights, MontelightPoints> direct({}, MontelightPoints(faults, scene));
  return MontelightTracer(MontelightTracer::no_limit, direct, {}, MontelightRoulette(faults));
}

/// What its film keeps of a sample.
inline Rgb<double> montelight_kept(const MontelightFaults& faults, const Rgb<double>& radiance) {
  return faults.clamped ? Rgb<double>(radiance.min(1)) : radiance;
}

}  // namespace fairlight
