// Nothing is passed: the fragment shader reads its parameters itself
// (Core/Recipe/ShaderAssembly.h).

void PassParameters() {}
