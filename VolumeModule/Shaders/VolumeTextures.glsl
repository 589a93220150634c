// The textures of a march that belong to one volume. C++ makes a struct of this file too, and finds
// the names here: March/Device/MarchTextures.h.

uniform sampler3D volumeTexture;
uniform sampler3D fieldTexture;     // nearest; of bricks or cells, as the file of slot Step tells
uniform sampler3D gapTexture;       // nearest; GapField
uniform sampler3D maskTexture;      // nearest; content and reach of each voxel
uniform samplerBuffer opticalTable; // (r, g, b, extinction), table behind table
uniform sampler2D preIntegratedTable;
uniform samplerBuffer twoValueTable;        // (r, g, b, opacity over a unit distance), x fastest
uniform samplerBuffer gradientOpacityTable; // factors of four components in an entry
uniform samplerBuffer lightTexels;          // five for each light that is not at the eye
uniform samplerBuffer isosurfaces;          // two texels each: color and optical depth; isovalue
uniform samplerBuffer spacingTable; // of a bin: where it changes, the voxel there, slopes around it
