// The textures of a march that belong to one volume. C++ makes a struct of this file too, and takes
// the names from here: Core/Parameters/MarchTextures.h. Packets of rays read most of them in
// memory.

uniform sampler3D volumeTexture;      // values of up to four components
uniform sampler3D gradientTexture;    // differences over two voxels, of the first component
uniform sampler3D fieldTexture;       // nearest; of bricks, cells or voxels, see the files of Step
uniform sampler3D gapTexture;         // nearest; of cells, see Gaps/Cells.glsl
uniform sampler3D maskTexture;        // nearest; content and reach, see Mask/Voxels.glsl
uniform samplerBuffer opticalTable;   // (r, g, b, extinction [1/mm]), one table after another
uniform sampler2D preIntegratedTable; // means between two scalars
uniform samplerBuffer twoValueTable;  // (r, g, b, opacity over a unit distance), x fastest
uniform samplerBuffer gradientOpacityTable; // factors of opacity of four components, [0, 1]
uniform samplerBuffer lightTexels;          // five for each light that is not at the eye
uniform samplerBuffer skyDirections;        // (direction in the grid [1/mm], weight)
uniform samplerBuffer isosurfaces;          // two each: (r, g, b, optical depth), (isovalue)
uniform samplerBuffer spacingTable;         // bins of all axes, see Spacing/Uneven.glsl
