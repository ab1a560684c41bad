#pragma once

#include <fairlight/estimators/gaussian_filter.h>
#include <fairlight/estimators/lens.h>
#include <fairlight/render/camera.h>

/// Wrong filters and lenses, each a bug of a class that somebody shipped; see wrong_components.h.
namespace fairlight::faults {

/// The distance from the lens's centre is uniform, not its square: the square root is missing, and the middle crowded.
template <class Real>
struct CrowdedAperture : CircularAperture<Real> {
  explicit CrowdedAperture(Real radius) : CircularAperture<Real>(radius), radius_(radius) {}
  Vec2<Real> sample(const Vec2<Real>& u) const {
    using std::cos;
    using std::sin;
    const Real phi = Real(2) * pi<Real> * u.y();
    return {radius_ * u.x() * cos(phi), radius_ * u.x() * sin(phi)};
  }

 private:
  Real radius_;
};

/// A square of the disk's area in the disk's place.
template <class Real>
struct SquareAperture : CircularAperture<Real> {
  explicit SquareAperture(Real radius) : CircularAperture<Real>(radius), radius_(radius) {}
  Vec2<Real> sample(const Vec2<Real>& u) const {
    using std::sqrt;
    const Real side = sqrt(Real(pi<Real>)) * radius_;
    return {side * (u.x() - Real(0.5)), side * (u.y() - Real(0.5))};
  }

 private:
  Real radius_;
};

/// The density of a Gaussian that was never cut off, on draws that are. On record: the class of pbrt-v3 #319.
template <class Real>
class UnnormalisedGaussian : public GaussianFilter<Real> {
 public:
  UnnormalisedGaussian(Real deviation, Real radius) : GaussianFilter<Real>(deviation, radius) {
    using std::erf;
    using std::sqrt;
    const Real kept = erf(radius / (sqrt(Real(2)) * deviation));
    kept_ = kept * kept;
  }
  Density<Area, Real> pdf(const Vec2<Real>& x) const {
    return Density<Area, Real>(GaussianFilter<Real>::pdf(x).value() * kept_);
  }

 private:
  Real kept_;
};

/// Focused at a distance along the ray, on a sphere instead of a plane.
template <class Real, class Aperture>
class SphericalFocus {
 public:
  SphericalFocus(Real focus_distance, Aperture aperture) : focus_(focus_distance), aperture_(aperture) {}
  LensRay<Real> ray(const Vec3<Real>& direction, const Vec2<Real>& u) const {
    return ThinLens(Real(focus_ / direction.norm()), aperture_).ray(direction, u);
  }

 private:
  Real focus_;
  Aperture aperture_;
};

/// The filter is drawn about a pixel's corner: half a pixel is missing.
struct RaysAboutCorners {
  template <class Filter, class Source>
  auto operator()(const Camera& camera, const Filter& filter, int x, int y, int width, int height,
                  Source& source) const {
    using Real = typename Filter::Scalar;
    const Vec2<Real> place = filter.sample(next_pair<Real>(source));
    return camera.ray<Real>(place.x() + rounded<Real>(x), place.y() + rounded<Real>(y), width, height, source);
  }
};

/// The filter and the lens are given the same numbers.
struct RaysThatShareNumbers {
  template <class Filter, class Source>
  auto operator()(const Camera& camera, const Filter& filter, int x, int y, int width, int height,
                  Source& source) const {
    Source same = source;
    using Real = typename Filter::Scalar;
    const Vec2<Real> place = filter.sample(next_pair<Real>(source));
    return camera.ray<Real>(place.x() + rounded<Real>(x + 0.5), place.y() + rounded<Real>(y + 0.5), width, height,
                            same);
  }
};

/// The pupil's area is left out of its density. On record: pbrt-v3 #162.
template <class Real>
struct PupilWithoutArea : CircularAperture<Real> {
  using CircularAperture<Real>::CircularAperture;
  Density<Area, Real> pdf(const Vec2<Real>&) const { return Density<Area, Real>(Real(1)); }
};

}  // namespace fairlight::faults
