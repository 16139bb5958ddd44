// Whether tests are to take little: with sanitizers they run ten times as long.
#pragma once

namespace nacre::test {

#ifdef NACRE_SANITIZED
inline constexpr bool cheap = true;
#else
inline constexpr bool cheap = false;
#endif

}  // namespace nacre::test
