#pragma once

#include <fairlight/estimators/rectangle_light.h>
#include <fairlight/estimators/sphere_sampling.h>
#include <fairlight/render/geometry.h>

namespace fairlight {

/// The luminaires of a scene in one arithmetic.
template <class Real>
class LightTable {
 public:
  explicit LightTable(const Scene& scene)
      : size_(static_cast<int>(scene.luminaires().size())),
        centres_(count(scene), [&](std::size_t i) { return light(scene, i).centre; }),
        radiances_(count(scene), [&](std::size_t i) { return light(scene, i).radiance; }),
        edges_x_(count(scene), [&](std::size_t i) { return edge(scene, i, light(scene, i).edge_x, 0); }),
        edges_y_(count(scene), [&](std::size_t i) { return edge(scene, i, light(scene, i).edge_y, 1); }),
        radii_(table_of<Real>(count(scene), [&](std::size_t i) { return light(scene, i).radius; })),
        powers_(table_of<Real>(count(scene), [&](std::size_t i) { return power_of(light(scene, i)); })),
        surfaces_(table_of<Real>(count(scene), [&](std::size_t i) { return light(scene, i).surface; })),
        shapes_(table_of<Real>(count(scene), [&](std::size_t i) { return light(scene, i).is_rectangle ? 1 : 0; })),
        indices_(table_of<Real>(scene.surfaces().size(), [&](std::size_t i) { return index_of(scene, i); })) {
    for (const Luminaire& each : scene.luminaires()) (each.is_rectangle ? rectangles_ : spheres_) = true;
  }

  int size() const { return size_; }
  bool has_spheres() const { return spheres_; }
  bool has_rectangles() const { return rectangles_; }

  Mask<Real> is_rectangle(const Index<Real>& i) const { return shapes_(i) == Real(1); }
  /// Luminaire i as a sphere; for a rectangle, its bounding sphere.
  SphereLight<Real> sphere(const Index<Real>& i, const Mask<Real>& on_surface) const {
    return {centres_(i), radii_(i), on_surface};
  }
  /// Luminaire i as a rectangle; for a sphere, an arbitrary one.
  RectangleLight<Real> rectangle(const Index<Real>& i, const Mask<Real>& on_surface) const {
    const Vec3<Real> x = edges_x_(i), y = edges_y_(i);
    return {centres_(i) - (x + y) * Real(0.5), x, y, on_surface};
  }
  Rgb<Real> emission(const Index<Real>& i) const { return radiances_(i).array(); }
  /// The index of its surface in the scene.
  Real surface(const Index<Real>& i) const { return surfaces_(i); }
  /// The index of the luminaire that a surface is, or -1.
  Real index(const Index<Real>& surface) const { return indices_(surface); }

  /// An estimate, up to a constant factor, of what luminaire i contributes to a point: its power
  /// over the squared distance, which is at least its squared radius. Positive wherever the
  /// luminaire contributes.
  Real contribution(const Index<Real>& light, const Vec3<Real>& point) const {
    using std::max;
    const Real radius = radii_(light);
    return powers_(light) / max(Real((centres_(light) - point).squaredNorm()), Real(radius * radius));
  }

 private:
  static std::size_t count(const Scene& scene) { return scene.luminaires().size(); }
  static const Luminaire& light(const Scene& scene, std::size_t i) { return scene.luminaires()[i]; }
  static Vec3<double> edge(const Scene& scene, std::size_t i, const Vec3<double>& edge, int axis) {
    return light(scene, i).is_rectangle ? edge : Vec3<double>::Unit(axis);
  }
  static double index_of(const Scene& scene, std::size_t surface) {
    for (std::size_t i = 0; i < count(scene); ++i) {
      if (light(scene, i).surface == static_cast<int>(surface)) return static_cast<double>(i);
    }
    return -1;
  }

  int size_;
  Table3<Real> centres_, radiances_, edges_x_, edges_y_;
  Table<Real> radii_, powers_, surfaces_, shapes_, indices_;
  bool spheres_ = false, rectangles_ = false;
};

}  // namespace fairlight
