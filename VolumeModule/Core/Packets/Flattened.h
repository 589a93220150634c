#ifndef Varimarch_Core_Packets_Flattened_h
#define Varimarch_Core_Packets_Flattened_h

// Inlines everything that a function calls, so that lanes stay in registers. With the checks of a
// sanitizer such a function would take a compiler ten minutes.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define FLATTENED
#else
#define FLATTENED [[gnu::flatten]]
#endif

#endif
