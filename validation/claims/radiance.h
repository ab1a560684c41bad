#pragma once

#include <memory>
#include <tuple>

#include <fairlight/render/path_tracer.h>
#include <fairlight/validation/checks/estimand.h>

namespace fairlight {

/// The radiance that a path tracer finds along a ray of a scene, in every arithmetic:
/// draw(type_identity<Real>, source) gives an Rgb<Real>. `make(type_identity<Real>)` gives the
/// tracer for a Real.
template <class Make>
class RadianceAlong {
 public:
  RadianceAlong(const Scene& scene, const Ray<double>& ray, const Make& make)
      : scenes_(std::make_shared<const TracedScene<double>>(scene),
                std::make_shared<const TracedScene<Packet>>(scene)),
        tracers_(make(std::type_identity<double>{}), make(std::type_identity<Packet>{})),
        ray_(ray) {}

  /// For `along` alone.
  RadianceAlong(const Scene& scene, const Make& make) : RadianceAlong(scene, {{0, 0, 0}, {0, 0, 1}, -1}, make) {}

  template <class Real, class Source>
  Rgb<Real> operator()(std::type_identity<Real> real, Source& source) const {
    const Ray<Real> ray{rounded_vector<Real>(ray_.origin), rounded_vector<Real>(ray_.direction),
                        rounded<Real>(ray_.origin_primitive)};
    return along(ray, real, source);
  }

  /// The radiance along another ray of the same scene.
  template <class Real, class Source>
  Rgb<Real> along(const Ray<Real>& ray, std::type_identity<Real>, Source& source) const {
    constexpr std::size_t i = lanes < Real >> 1 ? 1 : 0;
    return std::get<i>(tracers_).template radiance<Real>(*std::get<i>(scenes_), ray, source);
  }

 private:
  std::tuple<std::shared_ptr<const TracedScene<double>>, std::shared_ptr<const TracedScene<Packet>>> scenes_;
  std::tuple<decltype(std::declval<Make>()(std::type_identity<double>{})),
             decltype(std::declval<Make>()(std::type_identity<Packet>{}))>
      tracers_;
  Ray<double> ray_;
};

/// The same tracer in every arithmetic.
template <class Tracer>
auto always(const Tracer& tracer) {
  return [tracer]<class Real>(std::type_identity<Real>) { return tracer; };
}

}  // namespace fairlight
