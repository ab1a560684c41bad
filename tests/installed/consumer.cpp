// Somebody else's program: one header of each installed library, and a claim of the kit checked from outside.
#include <cstdio>

#include <fairlight/estimators/hemisphere.h>
#include <fairlight/render/cornell.h>
#include <fairlight/stats/verdict.h>
#include <fairlight/validation/conformance.h>
#include <fairlight/validation/registry.h>

int main() {
  using namespace fairlight;
  const Conformance conformance{{.seed = 1, .margin = 0.05}, 1};
  const auto outcomes = run_claims(select_claims({"pick.one.dice"}), conformance);
  std::printf("%s, %zu surfaces\n", name(overall(outcomes)),
              built_in_scene("cornell-simple").scene.surfaces().size());
  return overall(outcomes) == Verdict::certified ? 0 : 1;
}
