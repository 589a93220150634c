#ifndef Varimarch_Frame_SurfaceChoices_h
#define Varimarch_Frame_SurfaceChoices_h

#include "Frame/Frame.h"

namespace varimarch
{

/// Chooses the isosurfaces or the slice of a frame, if it shows any. Requires its settings,
/// geometry and components.
/// @return false if the frame asks for surfaces, but for none in particular
/// @throws std::invalid_argument or std::runtime_error with a sentence for the user, if they cannot
/// be drawn
bool ChooseSurfaces(Frame& frame);

}

#endif
