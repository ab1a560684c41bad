#include <fairlight/stats/verdict.h>

namespace fairlight {

const char* name(Verdict verdict) {
  switch (verdict) {
    case Verdict::certified:
      return "certified";
    case Verdict::biased:
      return "biased";
    case Verdict::undecided:
      break;
  }
  return "undecided";
}

const char* name(Guarantee guarantee) {
  switch (guarantee) {
    case Guarantee::deterministic:
      return "deterministic";
    case Guarantee::exact:
      return "exact";
    case Guarantee::exact_given_tail:
      return "exact, given its tail";
    case Guarantee::asymptotic:
      break;
  }
  return "asymptotic";
}

Verdict worse(Verdict a, Verdict b) {
  if (a == Verdict::biased || b == Verdict::biased) return Verdict::biased;
  if (a == Verdict::undecided || b == Verdict::undecided) return Verdict::undecided;
  return Verdict::certified;
}

}  // namespace fairlight
