#pragma once

#include <algorithm>
#include <array>
#include <functional>

#include <fairlight/estimators/dielectric.h>
#include <fairlight/estimators/glossy.h>
#include <fairlight/estimators/lambertian.h>
#include <fairlight/estimators/mirror.h>
#include <fairlight/estimators/rough_conductor.h>
#include <fairlight/render/geometry.h>

namespace fairlight {

/// The materials of a scene's surfaces, in one arithmetic.
template <class Real>
class Materials {
 public:
  explicit Materials(const Scene& scene)
      : albedos_(scene.surfaces().size(), [&](std::size_t i) { return scene.surfaces()[i].material.albedo; }),
        radiances_(scene.surfaces().size(), [&](std::size_t i) { return scene.surfaces()[i].radiance; }),
        parameters_(table_of<Real>(scene.surfaces().size(),
                                   [&](std::size_t i) { return scene.surfaces()[i].material.parameter; })),
        kinds_(table_of<Real>(scene.surfaces().size(), [&](std::size_t i) {
          return static_cast<double>(scene.surfaces()[i].material.kind);
        })) {
    for (const Surface& surface : scene.surfaces()) has_[static_cast<std::size_t>(surface.material.kind)] = true;
  }

  Rgb<Real> albedo(const Index<Real>& surface) const { return albedos_(surface).array(); }
  Rgb<Real> emission(const Index<Real>& surface) const { return radiances_(surface).array(); }
  Real parameter(const Index<Real>& surface) const { return parameters_(surface); }

  /// Whether all surfaces are diffuse (the first kind), whether any surface has a kind, and in
  /// which lanes this surface has it.
  bool all_diffuse() const { return std::none_of(has_.begin() + 1, has_.end(), std::identity()); }
  bool has(Material::Kind kind) const { return has_[static_cast<std::size_t>(kind)]; }
  Mask<Real> is(Material::Kind kind, const Index<Real>& surface) const {
    return kinds_(surface) == Real(static_cast<Lane<Real>>(kind));
  }

 private:
  Table3<Real> albedos_, radiances_;
  Table<Real> parameters_, kinds_;
  std::array<bool, Material::kinds> has_{};
};

/// The BSDF of the surface at a vertex, in world directions. Lanes may have different kinds.
/// Diffuse surfaces are sampled by `Directions`.
template <class Real, template <class> class Directions = CosineHemisphere>
class SurfaceBsdf {
 public:
  using Kind = Material::Kind;

  /// `outward`: the unit normal; `out`: the direction towards the viewer, in the world. The side
  /// towards the viewer reflects; glass distinguishes its inside from its outside.
  SurfaceBsdf(const Materials<Real>& materials, const Index<Real>& surface, const Vec3<Real>& outward,
              const Vec3<Real>& out, const Directions<Real>& directions = Directions<Real>())
      : materials_(materials),
        surface_(surface),
        albedo_(materials.albedo(surface)),
        normal_(select(flipped(materials, surface, outward, out), Vec3<Real>(-outward), outward)),
        frame_(normal_),
        out_(frame_.to_local(out)),
        directions_(directions) {}

  /// The normal on the viewer's side; for glass, the outward normal.
  const Vec3<Real>& normal() const { return normal_; }
  const Rgb<Real>& albedo() const { return albedo_; }

  /// The BSDF [1/sr], without the cosine; 0 below the surface, and for delta distributions.
  Rgb<Real> eval_world(const Vec3<Real>& direction) const {
    const Vec3<Real> in = frame_.to_local(direction);
    return of_kind([&](const auto& bsdf) { return Rgb<Real>(bsdf.eval(out_, in)); });
  }

  /// The density with which sample_world draws a direction.
  Density<SolidAngle, Real> pdf_world(const Vec3<Real>& direction) const {
    const Vec3<Real> in = frame_.to_local(direction);
    return Density<SolidAngle, Real>(of_kind([&](const auto& bsdf) { return bsdf.pdf(out_, in).value(); }));
  }

  /// Samples a bounce; its direction is in the world.
  Bounce<Real> sample_world(const Vec2<Real>& u) const {
    Bounce<Real> bounce = of_kind([&](const auto& bsdf) {
      constexpr int numbers = std::decay_t<decltype(bsdf)>::dimensions;
      return bsdf.sample(out_, u.template head<numbers>());
    });
    bounce.in = frame_.to_world(bounce.in);
    return bounce;
  }

  /// Lanes with a delta distribution, whose directions no shadow ray can sample.
  Mask<Real> is_single() const {
    Mask<Real> single(false);
    for (const Kind kind : {Kind::mirror, Kind::glass}) {
      if (materials_.has(kind)) single = single || materials_.is(kind, surface_);
    }
    return single;
  }

 private:
  static Mask<Real> flipped(const Materials<Real>& materials, const Index<Real>& surface, const Vec3<Real>& outward,
                            const Vec3<Real>& out) {
    const Mask<Real> from_inside = outward.dot(out) < Real(0);
    return materials.has(Kind::glass) ? from_inside && !materials.is(Kind::glass, surface) : from_inside;
  }

  static Real choose(const Mask<Real>& mask, const Real& a, const Real& b) { return select(mask, a, b); }
  static Rgb<Real> choose(const Mask<Real>& mask, const Rgb<Real>& a, const Rgb<Real>& b) {
    return select(mask, a, b);
  }
  static Bounce<Real> choose(const Mask<Real>& mask, const Bounce<Real>& a, const Bounce<Real>& b) {
    return {select(mask, a.in, b.in), select(mask, a.weight, b.weight),
            Density<SolidAngle, Real>(select(mask, a.density.value(), b.density.value()))};
  }

  // Applies `of` to each lane's own BSDF. Only kinds that occur in the scene are evaluated. In
  // lanes of another kind the parameter is 1, which every kind's domain contains.
  auto of_kind(const auto& of) const {
    auto value = of(Lambertian<Real, Directions>(albedo_, directions_));
    if (materials_.all_diffuse()) return value;
    const auto add = [&](Kind kind, const auto& make) {
      if (!materials_.has(kind)) return;
      const Mask<Real> here = materials_.is(kind, surface_);
      if (any(here)) value = choose(here, of(make(select(here, materials_.parameter(surface_), Real(1)))), value);
    };
    add(Kind::gloss, [&](Real exponent) { return Glossy<Real>(albedo_, exponent); });
    add(Kind::metal, [&](Real roughness) {
      return RoughConductor<Real>(Ggx<Real>(roughness, roughness), ConstantReflectance<Real>(albedo_));
    });
    add(Kind::mirror, [&](Real) { return Mirror<Real>(albedo_); });
    add(Kind::glass, [](Real index) { return Dielectric<Real>(index); });
    return value;
  }

  const Materials<Real>& materials_;
  Index<Real> surface_;
  Rgb<Real> albedo_;
  Vec3<Real> normal_;
  Frame<Real> frame_;
  Vec3<Real> out_;
  Directions<Real> directions_;
};

}  // namespace fairlight
