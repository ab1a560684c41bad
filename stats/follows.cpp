#include <algorithm>

#include <fairlight/stats/follows.h>

namespace fairlight {

Trial detail::half_of(const Trial& trial) {
  Trial half = trial;
  half.alpha /= 2;
  return half;
}

Finding detail::both(const Finding& cells, const Finding& moments) {
  Finding finding = moments.verdict == Verdict::certified ? cells : moments;
  finding.draws = cells.draws + moments.draws;
  if (moments.verdict != Verdict::certified)
    finding.note = "a moment of the Rosenblatt transform" + (moments.note.empty() ? "" : ": " + moments.note);
  return finding;
}

}  // namespace fairlight
