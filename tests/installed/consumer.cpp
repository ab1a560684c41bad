// Somebody else's program: one header of each installed library, and a claim of the kit checked from outside.
#include <cstdio>

#include <fairlight/estimators/hemisphere.h>
#include <fairlight/render/built_in_scenes.h>
#include <fairlight/stats/verdict.h>
#include <fairlight/validation/run/registry.h>
#include <fairlight/validation/run/run_claims.h>

int main() {
  using namespace fairlight;
  const RunOptions run_options{{.seed = 1, .margin = 0.05}, 1};
  const auto outcomes = run_claims(select_claims({"pick.one.dice"}), run_options);
  std::printf("%s, %zu surfaces\n", name(overall(outcomes)),
              built_in_scene("cornell-simple").scene.surfaces().size());
  return overall(outcomes) == Verdict::certified ? 0 : 1;
}
