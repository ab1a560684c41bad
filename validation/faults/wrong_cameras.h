#pragma once

#include <fairlight/estimators/gaussian_filter.h>
#include <fairlight/estimators/lens.h>
#include <fairlight/render/camera.h>

/// Wrong filters and lenses, of classes of bugs that projects shipped; see wrong_components.h.
namespace fairlight::faults {

/// The distance from the centre of the lens is uniform instead of its square: the square root is
/// missing, and points crowd in the middle.
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

/// A square with the area of the disk, in place of the disk.
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

/// Draws from a truncated Gaussian, with the density of one that is not truncated.
/// On record: the class of pbrt-v3 #319.
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

/// Focuses at a distance along the ray, so on a sphere instead of a plane.
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

/// Centres the filter on the corner of a pixel: half a pixel is missing.
struct RaysAboutCorners {
  template <class Filter, class Source>
  auto operator()(const Camera& camera, const Filter& filter, int x, int y, int width, int height,
                  Source& source) const {
    using Real = typename Filter::Scalar;
    const Vec2<Real> place = filter.sample(next_pair<Real>(source));
    return camera.ray<Real>(place.x() + rounded<Real>(x), place.y() + rounded<Real>(y), width, height, source);
  }
};

/// The filter and the lens use the same random numbers.
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

/// Leaves the area of the pupil out of its density.
/// On record: pbrt-v3 #162.
template <class Real>
struct PupilWithoutArea : CircularAperture<Real> {
  using CircularAperture<Real>::CircularAperture;
  Density<Area, Real> pdf(const Vec2<Real>&) const { return Density<Area, Real>(Real(1)); }
};

}  // namespace fairlight::faults
