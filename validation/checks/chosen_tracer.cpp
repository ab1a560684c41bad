// Compiled once for the whole program and, for packets, once for each instruction set.

#include <fairlight/render/strategies.h>
#include <fairlight/validation/checks/chosen_tracer.h>

namespace fairlight {

template <class Real>
struct ChosenTracer<Real>::Tracer {
  decltype(chosen_tracer<Real>(std::declval<const Strategies&>(), std::declval<const Scene&>())) path_tracer;
};

template <class Real>
ChosenTracer<Real>::ChosenTracer(const RenderSettings& settings, const Scene& scene)
    : tracer_(std::make_shared<const Tracer>(Tracer{chosen_tracer<Real>(Strategies(settings, scene), scene)})) {}

template <class Real>
Rgb<Real> ChosenTracer<Real>::trace(const TracedScene<Real>& scene, const Ray<Real>& ray,
                                    NumberSource<Real>& source) const {
  return tracer_->path_tracer.template radiance<Real>(scene, ray, source);
}

template class ChosenTracer<Packet>;
#if !defined(FAIRLIGHT_ENTRY)  // doubles have one set of instructions
template class ChosenTracer<double>;
#endif

}  // namespace fairlight
