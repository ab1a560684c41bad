#pragma once

/// Of a function that calls hundreds of small ones about packets, of which a compiler leaves some uninlined: all of them are.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define FAIRLIGHT_FLATTEN  // a sanitizer's checks, all in one function, take a compiler a quarter of an hour
#else
#define FAIRLIGHT_FLATTEN [[gnu::flatten]]
#endif
