// kernel.h: the packet renderers of this machine (targets/kernel.cpp).
#pragma once

#include <string_view>

#include "tracer/plan.h"
#include "tracer/render.h"

namespace litmus {

template <Real R>
using RowRenderer = void (*)(const Plan<R>& plan, const RenderOptions& options, int y,
                             Rendering& result, Counts* counts);

/// Renders rows of a picture in packets, with the bits of the scalar renderer.
struct PacketKernel {
  int float_lanes = 0, double_lanes = 0;
  RowRenderer<float> float_row = nullptr;
  RowRenderer<double> double_row = nullptr;
  std::string_view target = {};
};

/// The packet renderers that this processor can run, the widest first: "avx512", "avx2". Empty on
/// other processors, where every picture is rendered pixel by pixel.
const std::vector<PacketKernel>& packet_kernels();

}  // namespace litmus
