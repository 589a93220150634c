// The textures of a march that do not belong to one of its volumes. C++ makes a struct of this file
// too, and finds the names here: March/Device/MarchTextures.h.

uniform sampler2D depthTexture;       // depth buffer of the opaque geometry
uniform sampler2D noiseTexture;       // blue noise
uniform samplerBuffer clippingPlanes; // grid space; dot(plane, position) >= 0 is left
uniform sampler2D gatheredTexture;    // sums of the rays of a volume in blocks
uniform sampler2D coarseTexture;      // image drawn with fewer or more rays than pixels
uniform sampler2D sumTexture;         // sum of accumulated images
uniform samplerBuffer marchedTexture; // marched by the processor: row by row, image behind image
