// kernel.cpp: which packet renderers this processor can run.
#include "tracer/kernel.h"

namespace litmus {

PacketKernel packet_kernel_avx2();
PacketKernel packet_kernel_avx512();

namespace {

[[maybe_unused]] void add(std::vector<PacketKernel>& kernels, std::string_view target,
                          PacketKernel kernel) {
  kernel.target = target;
  kernels.push_back(kernel);
}

std::vector<PacketKernel> find_kernels() {
  std::vector<PacketKernel> kernels;
#ifdef LITMUS_KERNEL_avx512
  if (__builtin_cpu_supports("x86-64-v4")) add(kernels, "avx512", packet_kernel_avx512());
#endif
#ifdef LITMUS_KERNEL_avx2
  if (__builtin_cpu_supports("x86-64-v3")) add(kernels, "avx2", packet_kernel_avx2());
#endif
  return kernels;
}

}  // namespace

const std::vector<PacketKernel>& packet_kernels() {
  static const std::vector<PacketKernel> kernels = find_kernels();
  return kernels;
}

}  // namespace litmus
