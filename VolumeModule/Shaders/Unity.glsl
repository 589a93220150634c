// A copy of a uniform is what compilers make the uniform again; its product with a number that they
// do not know is none, and this number changes nothing. See Core/UniformsReadOnce.h.

uniform float unity = 1.0;
