#pragma once

#include <memory>

#include <fairlight/render/scene.h>
#include <fairlight/render/settings.h>
#include <fairlight/render/traced_scene.h>
#include <fairlight/validation/checks/numbers.h>

namespace fairlight {

/// The path tracer of the strategies that settings name, in a scene. It is compiled once for each
/// arithmetic and instruction set, in chosen_tracer.cpp: its many strategies take long.
template <class Real>
class ChosenTracer {
 public:
  /// Throws std::invalid_argument as Strategies does.
  ChosenTracer(const RenderSettings& settings, const Scene& scene);

  /// The radiance along a ray [W/(sr m^2)].
  template <class>
  Rgb<Real> radiance(const TracedScene<Real>& scene, const Ray<Real>& ray, NumberSource<Real>& source) const {
    return trace(scene, ray, source);
  }

 private:
  struct Tracer;
  Rgb<Real> trace(const TracedScene<Real>& scene, const Ray<Real>& ray, NumberSource<Real>& source) const;

  std::shared_ptr<const Tracer> tracer_;
};

extern template class ChosenTracer<double>;
extern template class ChosenTracer<Packet>;

}  // namespace fairlight
