// triage.cpp: FLIP and SSIM side by side.
#include "compare/triage.h"

#include "compare/flip.h"
#include "compare/ssim.h"

namespace litmus {

Triage triage(const Picture& ours, const Picture& theirs) {
  return {ldr_flip(ours, theirs), hdr_flip(ours, theirs), ssim(ours, theirs)};
}

}  // namespace litmus
