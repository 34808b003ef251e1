/* OpenGL's functions, found when the library is opened: gl->DrawElements() is glDrawElements(). */
#ifndef GLINT_SIM_GL_FUNCTIONS_H
#define GLINT_SIM_GL_FUNCTIONS_H

#include <GL/glcorearb.h>

/* X(NAME in the name of the type, Name) */
#define GLINT_GL_FUNCTIONS(X)                                                                      \
    X(ACTIVETEXTURE, ActiveTexture)                                                                \
    X(ATTACHSHADER, AttachShader)                                                                  \
    X(BINDBUFFER, BindBuffer)                                                                      \
    X(BINDFRAMEBUFFER, BindFramebuffer)                                                            \
    X(BINDRENDERBUFFER, BindRenderbuffer)                                                          \
    X(BINDTEXTURE, BindTexture)                                                                    \
    X(BINDVERTEXARRAY, BindVertexArray)                                                            \
    X(BUFFERDATA, BufferData)                                                                      \
    X(CHECKFRAMEBUFFERSTATUS, CheckFramebufferStatus)                                              \
    X(CLEAR, Clear)                                                                                \
    X(CLEARCOLOR, ClearColor)                                                                      \
    X(CLEARDEPTH, ClearDepth)                                                                      \
    X(COMPILESHADER, CompileShader)                                                                \
    X(CREATEPROGRAM, CreateProgram)                                                                \
    X(CREATESHADER, CreateShader)                                                                  \
    X(DELETEPROGRAM, DeleteProgram)                                                                \
    X(DELETESHADER, DeleteShader)                                                                  \
    X(DEPTHFUNC, DepthFunc)                                                                        \
    X(DISABLE, Disable)                                                                            \
    X(DRAWELEMENTS, DrawElements)                                                                  \
    X(ENABLE, Enable)                                                                              \
    X(ENABLEVERTEXATTRIBARRAY, EnableVertexAttribArray)                                            \
    X(FRAMEBUFFERRENDERBUFFER, FramebufferRenderbuffer)                                            \
    X(FRONTFACE, FrontFace)                                                                        \
    X(GENBUFFERS, GenBuffers)                                                                      \
    X(GENFRAMEBUFFERS, GenFramebuffers)                                                            \
    X(GENRENDERBUFFERS, GenRenderbuffers)                                                          \
    X(GENTEXTURES, GenTextures)                                                                    \
    X(GENVERTEXARRAYS, GenVertexArrays)                                                            \
    X(GETERROR, GetError)                                                                          \
    X(GETINTEGERV, GetIntegerv)                                                                    \
    X(GETPROGRAMINFOLOG, GetProgramInfoLog)                                                        \
    X(GETPROGRAMIV, GetProgramiv)                                                                  \
    X(GETSHADERINFOLOG, GetShaderInfoLog)                                                          \
    X(GETSHADERIV, GetShaderiv)                                                                    \
    X(GETSTRING, GetString)                                                                        \
    X(GETUNIFORMLOCATION, GetUniformLocation)                                                      \
    X(LINKPROGRAM, LinkProgram)                                                                    \
    X(READPIXELS, ReadPixels)                                                                      \
    X(RENDERBUFFERSTORAGE, RenderbufferStorage)                                                    \
    X(SHADERSOURCE, ShaderSource)                                                                  \
    X(TEXIMAGE2D, TexImage2D)                                                                      \
    X(TEXPARAMETERI, TexParameteri)                                                                \
    X(UNIFORM1F, Uniform1f)                                                                        \
    X(UNIFORM1I, Uniform1i)                                                                        \
    X(UNIFORM1UI, Uniform1ui)                                                                      \
    X(UNIFORM2F, Uniform2f)                                                                        \
    X(UNIFORM3FV, Uniform3fv)                                                                      \
    X(UNIFORMMATRIX3FV, UniformMatrix3fv)                                                          \
    X(USEPROGRAM, UseProgram)                                                                      \
    X(VERTEXATTRIBPOINTER, VertexAttribPointer)                                                    \
    X(VIEWPORT, Viewport)

typedef struct glint_gl {
#define GLINT_GL_FUNCTION(NAME, Name) PFNGL##NAME##PROC Name;
    GLINT_GL_FUNCTIONS(GLINT_GL_FUNCTION)
#undef GLINT_GL_FUNCTION
} glint_gl;

#endif
