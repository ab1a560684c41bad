#pragma once

#include <array>

#include <fairlight/estimators/table.h>
#include <fairlight/render/flatten.h>
#include <fairlight/render/lit_side.h>

namespace fairlight {

/// A table with three numbers per row, such as the channels of a colour.
template <class Real>
class Table3 {
 public:
  /// of(i) returns row i of n.
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

/// A table with one number per row.
template <class Real>
Table<Real> table_of(std::size_t n, const auto& of) {
  std::vector<double> column;
  for (std::size_t i = 0; i < n; ++i) column.push_back(of(i));
  return Table<Real>(column);
}

/// The surfaces of a scene in one arithmetic. Tests a packet of rays against one surface after
/// another. For a sphere with all light on one side it computes one root only, which is half the
/// work: see LitSide.
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
      const bool obstacle = can_occlude(scene, i);
      const auto add = [&](auto& all, auto& obstacles, const auto& shape) {
        all.push_back({shape, static_cast<Number>(i)});
        if (obstacle) obstacles.push_back(all.back());
      };
      if (surface.rectangle) {
        add(rectangles_, rectangles_between_, narrowed(*surface.rectangle));
      } else {
        const LitSide side = lit_side(scene, i);
        add(side == LitSide::inside    ? lit_inside_
            : side == LitSide::outside ? lit_outside_
                                       : spheres_,
            spheres_between_, narrowed(surface.shape));
      }
    }
  }

  /// The first surface that a ray hits. A path that starts on an unlit side, and not on a surface,
  /// hits none.
  FAIRLIGHT_FLATTEN Hit<Real> intersect(const Ray<Real>& ray) const {
    using std::max;
    Real dark(0);
    Nearest nearest;
    each(lit_inside_, ray, [&](const auto& sphere, const Mask<Real>& leaving, Real index) {
      const auto [exit, twice_implicit] = sphere.exit(ray.origin, ray.direction, leaving);
      nearest.add(exit, index);
      dark = max(dark, twice_implicit);
    });
    each(lit_outside_, ray, [&](const auto& sphere, const Mask<Real>& leaving, Real index) {
      const auto [entry, twice_implicit] = sphere.entry(ray.origin, ray.direction, leaving);
      nearest.add(entry, index);
      dark = max(dark, Real(-twice_implicit));
    });
    const auto meet = [&](const auto& shape, const Mask<Real>& leaving, Real index) {
      nearest.add(shape.crossing(ray.origin, ray.direction, leaving), index);
    };
    each(spheres_, ray, meet);
    each(rectangles_, ray, meet);
    const Mask<Real> unlit = dark > Real(0) && ray.origin_primitive < Real(0);
    return {select(unlit, Real(infinity<Real>), nearest.crossing.distance()),
            select(unlit, Real(-1), nearest.surface)};
  }

  /// Whether nothing stands on a ray closer than `distance` [m], at which a point of the luminaire
  /// `target` lies. The ray starts at a vertex of a path on the lit side. The target is skipped: it
  /// is convex and the point faces the origin, so it cannot occlude itself.
  FAIRLIGHT_FLATTEN Mask<Real> visible(const Ray<Real>& ray, Real distance, Real target) const {
    using std::max;
    Real most(0);
    const auto stand = [&](const auto& shape, const Mask<Real>& leaving, Real index) {
      const Real obstruction = shape.obstruction(ray.origin, ray.direction, leaving, distance);
      most = max(most, select(index == target, Real(0), obstruction));
    };
    each(spheres_between_, ray, stand);
    each(rectangles_between_, ray, stand);
    return most <= Real(0);
  }

  /// The outward unit normal at a point of a surface. A hit far from the ray's origin is off the
  /// surface by the rounding of floats, and the gradient there does not have length 1.
  FAIRLIGHT_FLATTEN Vec3<Real> normal_at(const Index<Real>& surface, const Vec3<Real>& position) const {
    const Sphere<Real> shape{anchors_(surface), normals_(surface), curvatures_(surface)};
    const Vec3<Real> gradient = shape.normal_at(position);
    return gradient * Real(Real(1) / gradient.norm());
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

  struct Nearest {
    RationalHit<Real> crossing = RationalHit<Real>::nowhere();
    Real surface = Real(-1);

    void add(const RationalHit<Real>& other, Real index) {
      const Mask<Real> closer = other.before(crossing);
      crossing = {select(closer, other.numerator, crossing.numerator),
                  select(closer, other.denominator, crossing.denominator)};
      surface = select(closer, index, surface);
    }
  };

  static void each(const auto& shapes, const Ray<Real>& ray, const auto& visit) {
    for (const auto& [shape, index] : shapes)
      visit(shape.template in<Real>(), ray.origin_primitive == Real(index), Real(index));
  }

  std::vector<Indexed<Sphere<Number>>> lit_inside_, lit_outside_, spheres_, spheres_between_;
  std::vector<Indexed<Rectangle<Number>>> rectangles_, rectangles_between_;
  Table3<Real> anchors_, normals_;
  Table<Real> curvatures_;
};

}  // namespace fairlight
