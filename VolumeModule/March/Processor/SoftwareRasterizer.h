#ifndef Varimarch_March_Processor_SoftwareRasterizer_h
#define Varimarch_March_Processor_SoftwareRasterizer_h

namespace varimarch
{

/// Whether the current OpenGL context is drawn by the processor: llvmpipe.
bool IsSoftwareRasterizer();

}

#endif
