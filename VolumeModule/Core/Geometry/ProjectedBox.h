#ifndef Varimarch_Core_Geometry_ProjectedBox_h
#define Varimarch_Core_Geometry_ProjectedBox_h

#include "Core/Geometry/Box.h"
#include "Core/Geometry/Viewport.h"

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <array>

namespace varimarch
{

/// The corners of a box in the space of a view.
using CornersClip = std::array<glm::dvec4, 8>;

CornersClip CornersOf(const Box& box, const glm::dmat4& clipFromGrid);

/// The smallest box of another space around a box.
/// @param otherFromBox  affine
Box BoxAround(const Box& box, const glm::dmat4& otherFromBox);

/// False if all corners are beyond the same side of the view.
bool IsInView(const Box& box, const glm::dmat4& clipFromGrid);

/// The pixels that a box may cover, within the picture.
Viewport PixelsOf(const Box& box, const glm::dmat4& clipFromGrid, const Viewport& picture);

/// How far a corner moves at most from one view to another, of the width or height of the picture;
/// infinite where one is behind the eye.
double LargestMove(const CornersClip& from, const CornersClip& to);

}

#endif
