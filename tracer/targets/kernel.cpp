// kernel.cpp: the rows of a picture in packets, compiled once for each kind of processor.
//
// LITMUS_TARGET names the processor. No inline function may leave this file: the linker would keep
// one copy for the whole program, and it might be one that only this processor can run. So the
// build passes -fno-weak, which makes them all local, and a test looks at the object file.
#include "tracer/kernel.h"
#include "tracer/pixels.h"
#include "tracer/twin.h"

#define LITMUS_JOIN(a, b) a##b
#define LITMUS_NAME(a, b) LITMUS_JOIN(a, b)

namespace litmus {
namespace {

/// Twins where the processor has registers for both.
template <Real R>
#ifdef __AVX512VL__
using KernelValue = Twin<NativePacket<R>>;
#else
using KernelValue = NativePacket<R>;
#endif

template <Real R>
[[gnu::flatten]] void packet_row(const Plan<R>& plan, const RenderOptions& options, int y,
                                 Rendering& result, Counts* counts) {
  render_row<KernelValue<R>>(plan, options, y, result, counts);
}

}  // namespace

PacketKernel LITMUS_NAME(packet_kernel_, LITMUS_TARGET)() {
  return {kLanes<KernelValue<float>>, kLanes<KernelValue<double>>, packet_row<float>,
          packet_row<double>};
}

}  // namespace litmus
