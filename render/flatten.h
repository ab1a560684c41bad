#pragma once

/// Inlines every call inside a function. Code on packets makes hundreds of small calls, some of
/// which a compiler would not inline by itself.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || defined(FAIRLIGHT_NO_FLATTEN)
// With a sanitizer's checks, one such function takes a quarter of an hour to compile. The audit of
// mutants, which compiles one for each, has no need of speed.
#define FAIRLIGHT_FLATTEN
#else
#define FAIRLIGHT_FLATTEN [[gnu::flatten]]
#endif
