#ifndef Varimarch_Frame_ShadowCuller_h
#define Varimarch_Frame_ShadowCuller_h

class vtkRenderer;

namespace varimarch
{

/// Keeps a renderer from culling volumes out of the view whose shadows may fall on opaque geometry,
/// from the next image on: VTK does not draw a prop that is culled, nor does it tell anybody. Adds
/// a vtkCuller to the renderer, unless it has no culler or this one already.
void KeepShadowsOutOfView(vtkRenderer* renderer);

}

#endif
