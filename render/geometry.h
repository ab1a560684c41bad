#pragma once

#include <array>

#include <fairlight/estimators/table.h>
#include <fairlight/render/scene.h>

namespace fairlight {

/// Three numbers a row, such as the channels of a colour.
template <class Real>
class Table3 {
 public:
  /// of(i) gives row i of n.
  Table3(std::size_t n, const auto& of) {
    for (int c = 0; c < 3; ++c) {
      std::vector<double> column;
      for (std::size_t i = 0; i < n; ++i) column.push_back(of(i)[c]);
      columns_[static_cast<std::size_t>(c)] = Table<Real>(column);
    }
  }
  Vec3<Real> operator()(const Index<Real>& i) const { return {columns_[0](i), columns_[1](i), columns_[2](i)}; }

 private:
  std::array<Table<Real>, 3> columns_;
};

/// The same for one number a row.
template <class Real>
Table<Real> table_of(std::size_t n, const auto& of) {
  std::vector<double> column;
  for (std::size_t i = 0; i < n; ++i) column.push_back(of(i));
  return Table<Real>(column);
}

/// The surfaces of a scene in one arithmetic: every ray is tested against one surface after the other, all lanes at once.
template <class Real>
class Geometry {
 public:
  explicit Geometry(const Scene& scene)
      : anchors_(scene.surfaces().size(), [&](std::size_t i) { return scene.surfaces()[i].shape.anchor; }),
        normals_(scene.surfaces().size(), [&](std::size_t i) { return scene.surfaces()[i].shape.normal; }),
        curvatures_(table_of<Real>(scene.surfaces().size(),
                                   [&](std::size_t i) { return scene.surfaces()[i].shape.curvature; })) {
    for (std::size_t i = 0; i < scene.surfaces().size(); ++i) {
      const Surface& surface = scene.surfaces()[i];
      const auto index = static_cast<Number>(i);
      if (surface.rectangle) {
        rectangles_.push_back({narrowed(*surface.rectangle), index});
      } else {
        spheres_.push_back({narrowed(surface.shape), index});
      }
    }
  }

  /// The first surface that a ray meets.
  Hit<Real> intersect(const Ray<Real>& ray) const {
    auto nearest = Crossing<Real>::nowhere();
    Real surface(-1);
    each([&](const auto& shape, Real index) {
      const Crossing<Real> crossing = shape.crossing(ray.origin, ray.direction, ray.leaving == index);
      const Mask<Real> closer = crossing.before(nearest);
      nearest = {select(closer, crossing.numerator, nearest.numerator),
                 select(closer, crossing.denominator, nearest.denominator)};
      surface = select(closer, index, surface);
    });
    return {nearest.distance(), surface};
  }

  /// Whether nothing but the surface `target` stands on the ray closer than `distance` [m]. The target is convex
  /// and its point faces the origin, so it does not stand in its own way.
  Mask<Real> visible(const Ray<Real>& ray, Real distance, Real target) const {
    using std::max;
    Real most(0);
    each([&](const auto& shape, Real index) {
      const Real obstruction = shape.obstruction(ray.origin, ray.direction, ray.leaving == index, distance);
      most = max(most, select(index == target, Real(0), obstruction));
    });
    return most <= Real(0);
  }

  /// The outward unit normal at a point of a surface. A ray that comes from far away, where floats are sparse, ends some way off
  /// it, and the gradient there is not as long as 1.
  Vec3<Real> normal_at(const Index<Real>& surface, const Vec3<Real>& position) const {
    const Sphere<Real> shape{anchors_(surface), normals_(surface), curvatures_(surface)};
    const Vec3<Real> gradient = shape.normal_at(position);
    return gradient / gradient.norm();
  }

 private:
  using Number = Lane<Real>;
  template <class Shape>
  struct Indexed {
    Shape shape;
    Number index;
  };

  static Sphere<Number> narrowed(const Sphere<double>& s) {
    return {s.anchor.template cast<Number>(), s.normal.template cast<Number>(), static_cast<Number>(s.curvature)};
  }
  static Rectangle<Number> narrowed(const Rectangle<double>& r) {
    return {narrowed(r.plane), r.x.template cast<Number>(), r.y.template cast<Number>()};
  }

  void each(const auto& visit) const {
    for (const auto& [shape, index] : spheres_) visit(shape.template in<Real>(), Real(index));
    for (const auto& [shape, index] : rectangles_) visit(shape.template in<Real>(), Real(index));
  }

  std::vector<Indexed<Sphere<Number>>> spheres_;
  std::vector<Indexed<Rectangle<Number>>> rectangles_;
  Table3<Real> anchors_, normals_;
  Table<Real> curvatures_;
};

}  // namespace fairlight
