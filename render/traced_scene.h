#pragma once

#include <bit>

#include <fairlight/render/light_table.h>
#include <fairlight/render/surface_bsdf.h>

namespace fairlight {

/// A scene in one arithmetic, for tracing rays.
template <class Real>
class TracedScene {
 public:
  explicit TracedScene(const Scene& scene) : geometry_(scene), materials_(scene), lights_(scene) {}

  const Materials<Real>& materials() const { return materials_; }
  const LightTable<Real>& lights() const { return lights_; }

  Hit<Real> intersect(const Ray<Real>& ray, const Mask<Real>& /*asked*/) const { return geometry_.intersect(ray); }
  Mask<Real> visible(const Ray<Real>& ray, Real distance, Real target, const Mask<Real>& /*asked*/) const {
    return geometry_.visible(ray, distance, target);
  }
  Vec3<Real> normal_at(const Index<Real>& surface, const Vec3<Real>& position) const {
    return geometry_.normal_at(surface, position);
  }

 private:
  Geometry<Real> geometry_;
  Materials<Real> materials_;
  LightTable<Real> lights_;
};

/// A scene that counts the rays traced through it, lane by lane.
template <class Real>
class CountedScene {
 public:
  explicit CountedScene(const TracedScene<Real>& scene) : scene_(scene) {}

  const Materials<Real>& materials() const { return scene_.materials(); }
  const LightTable<Real>& lights() const { return scene_.lights(); }
  Hit<Real> intersect(const Ray<Real>& ray, const Mask<Real>& asked) const {
    count(asked);
    return scene_.intersect(ray, asked);
  }
  Mask<Real> visible(const Ray<Real>& ray, Real distance, Real target, const Mask<Real>& asked) const {
    count(asked);
    return scene_.visible(ray, distance, target, asked);
  }
  Vec3<Real> normal_at(const Index<Real>& surface, const Vec3<Real>& position) const {
    return scene_.normal_at(surface, position);
  }
  std::uint64_t rays() const { return rays_; }

 private:
  void count(const Mask<Real>& asked) const {
    rays_ += static_cast<std::uint64_t>(std::popcount(lane_bits(asked)));
  }

  const TracedScene<Real>& scene_;
  mutable std::uint64_t rays_ = 0;
};

}  // namespace fairlight
