// The textures of a march that do not belong to one of its volumes. C++ makes a struct of this file
// too, and takes the names from here: Core/Parameters/MarchTextures.h.

uniform sampler2D depthTexture; // depth buffer of the opaque geometry, [0, 1]
uniform sampler2D noiseTexture; // blue noise, lengths of first segments, (0, 1]
// Clipping planes in grid space. The dot product with (position, 1) is >= 0 at visible positions.
uniform samplerBuffer clippingPlanes;
uniform sampler2D gatheredTexture; // state of each ray after some blocks of a volume (BlendKept)
uniform sampler2D coarseTexture;   // image with fewer or more rays than pixels
uniform sampler2D sumTexture;      // sum of accumulated images
// Images that the processor has marched, one after another, each row by row from below.
uniform samplerBuffer marchedTexture;
// A TriangleTree of the opaque geometry that casts shadows; see originInCasters.
uniform samplerBuffer casterTree;
