#ifndef Varimarch_March_Processor_SoftwareRasterizer_h
#define Varimarch_March_Processor_SoftwareRasterizer_h

namespace varimarch
{

/// True if the current OpenGL context is drawn by the processor, with llvmpipe.
bool IsSoftwareRasterizer();

/// A software rasteriser ends a shader, and with it the ray, after this many iterations of all its
/// loops.
constexpr int MostShaderIterations = 1 << 16;

}

#endif
