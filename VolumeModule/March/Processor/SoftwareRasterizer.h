#ifndef Varimarch_March_Processor_SoftwareRasterizer_h
#define Varimarch_March_Processor_SoftwareRasterizer_h

namespace varimarch
{

/// True if the current OpenGL context is drawn by the processor, with llvmpipe.
bool IsSoftwareRasterizer();

}

#endif
