// The OpenGL functions that the project calls, found at run time. The list says exactly which.
#pragma once

#include <GL/glcorearb.h>
#include <functional>
#include <string>
#include <vector>

// X(name, NAME): glName with type PFNGLNAMEPROC. All are in OpenGL 4.3.
#define KD_GL_FUNCTIONS(X)                                                                                             \
    X(ActiveTexture, ACTIVETEXTURE)                                                                                    \
    X(AttachShader, ATTACHSHADER)                                                                                      \
    X(BeginQuery, BEGINQUERY)                                                                                          \
    X(BindBuffer, BINDBUFFER)                                                                                          \
    X(BindBufferBase, BINDBUFFERBASE)                                                                                  \
    X(BindFramebuffer, BINDFRAMEBUFFER)                                                                                \
    X(BindImageTexture, BINDIMAGETEXTURE)                                                                              \
    X(BindTexture, BINDTEXTURE)                                                                                        \
    X(BindVertexArray, BINDVERTEXARRAY)                                                                                \
    X(BlendEquation, BLENDEQUATION)                                                                                    \
    X(BlendFunc, BLENDFUNC)                                                                                            \
    X(BlendFunci, BLENDFUNCI)                                                                                          \
    X(BlitFramebuffer, BLITFRAMEBUFFER)                                                                                \
    X(BufferData, BUFFERDATA)                                                                                          \
    X(BufferSubData, BUFFERSUBDATA)                                                                                    \
    X(CheckFramebufferStatus, CHECKFRAMEBUFFERSTATUS)                                                                  \
    X(Clear, CLEAR)                                                                                                    \
    X(ClearBufferfv, CLEARBUFFERFV)                                                                                    \
    X(ClearBufferuiv, CLEARBUFFERUIV)                                                                                  \
    X(ClearColor, CLEARCOLOR)                                                                                          \
    X(ColorMask, COLORMASK)                                                                                            \
    X(CompileShader, COMPILESHADER)                                                                                    \
    X(CopyBufferSubData, COPYBUFFERSUBDATA)                                                                            \
    X(CopyImageSubData, COPYIMAGESUBDATA)                                                                              \
    X(CreateProgram, CREATEPROGRAM)                                                                                    \
    X(CreateShader, CREATESHADER)                                                                                      \
    X(DebugMessageCallback, DEBUGMESSAGECALLBACK)                                                                      \
    X(DeleteBuffers, DELETEBUFFERS)                                                                                    \
    X(DeleteFramebuffers, DELETEFRAMEBUFFERS)                                                                          \
    X(DeleteProgram, DELETEPROGRAM)                                                                                    \
    X(DeleteQueries, DELETEQUERIES)                                                                                    \
    X(DeleteShader, DELETESHADER)                                                                                      \
    X(DeleteTextures, DELETETEXTURES)                                                                                  \
    X(DeleteVertexArrays, DELETEVERTEXARRAYS)                                                                          \
    X(DepthFunc, DEPTHFUNC)                                                                                            \
    X(DepthMask, DEPTHMASK)                                                                                            \
    X(Disable, DISABLE)                                                                                                \
    X(DispatchCompute, DISPATCHCOMPUTE)                                                                                \
    X(DispatchComputeIndirect, DISPATCHCOMPUTEINDIRECT)                                                                \
    X(DrawArrays, DRAWARRAYS)                                                                                          \
    X(DrawBuffers, DRAWBUFFERS)                                                                                        \
    X(Enable, ENABLE)                                                                                                  \
    X(Enablei, ENABLEI)                                                                                                \
    X(EndQuery, ENDQUERY)                                                                                              \
    X(Finish, FINISH)                                                                                                  \
    X(FramebufferTexture2D, FRAMEBUFFERTEXTURE2D)                                                                      \
    X(GenBuffers, GENBUFFERS)                                                                                          \
    X(GenFramebuffers, GENFRAMEBUFFERS)                                                                                \
    X(GenQueries, GENQUERIES)                                                                                          \
    X(GenTextures, GENTEXTURES)                                                                                        \
    X(GenVertexArrays, GENVERTEXARRAYS)                                                                                \
    X(GetBufferSubData, GETBUFFERSUBDATA)                                                                              \
    X(GetError, GETERROR)                                                                                              \
    X(GetInteger64v, GETINTEGER64V)                                                                                    \
    X(GetIntegerv, GETINTEGERV)                                                                                        \
    X(GetObjectLabel, GETOBJECTLABEL)                                                                                  \
    X(GetProgramInfoLog, GETPROGRAMINFOLOG)                                                                            \
    X(GetProgramiv, GETPROGRAMIV)                                                                                      \
    X(GetQueryObjectui64v, GETQUERYOBJECTUI64V)                                                                        \
    X(GetQueryiv, GETQUERYIV)                                                                                          \
    X(GetShaderInfoLog, GETSHADERINFOLOG)                                                                              \
    X(GetShaderiv, GETSHADERIV)                                                                                        \
    X(GetString, GETSTRING)                                                                                            \
    X(GetStringi, GETSTRINGI)                                                                                          \
    X(GetTexImage, GETTEXIMAGE)                                                                                        \
    X(IsBuffer, ISBUFFER)                                                                                              \
    X(IsEnabled, ISENABLED)                                                                                            \
    X(IsFramebuffer, ISFRAMEBUFFER)                                                                                    \
    X(IsProgram, ISPROGRAM)                                                                                            \
    X(IsQuery, ISQUERY)                                                                                                \
    X(IsShader, ISSHADER)                                                                                              \
    X(IsTexture, ISTEXTURE)                                                                                            \
    X(IsVertexArray, ISVERTEXARRAY)                                                                                    \
    X(LinkProgram, LINKPROGRAM)                                                                                        \
    X(MemoryBarrier, MEMORYBARRIER)                                                                                    \
    X(ObjectLabel, OBJECTLABEL)                                                                                        \
    X(PixelStorei, PIXELSTOREI)                                                                                        \
    X(PopDebugGroup, POPDEBUGGROUP)                                                                                    \
    X(PushDebugGroup, PUSHDEBUGGROUP)                                                                                  \
    X(QueryCounter, QUERYCOUNTER)                                                                                      \
    X(ReadPixels, READPIXELS)                                                                                          \
    X(Scissor, SCISSOR)                                                                                                \
    X(ShaderSource, SHADERSOURCE)                                                                                      \
    X(TexBuffer, TEXBUFFER)                                                                                            \
    X(TexImage2D, TEXIMAGE2D)                                                                                          \
    X(TexParameteri, TEXPARAMETERI)                                                                                    \
    X(TexStorage2D, TEXSTORAGE2D)                                                                                      \
    X(TexSubImage2D, TEXSUBIMAGE2D)                                                                                    \
    X(UseProgram, USEPROGRAM)                                                                                          \
    X(Viewport, VIEWPORT)

namespace kd {

struct GlMessages;

/// One table of functions per context. `gl.DrawArrays(...)` is glDrawArrays.
struct GlApi {
    using GetProc = std::function<void*(const char* name)>;

#define KD_GL_MEMBER(name, NAME) PFNGL##NAME##PROC name = nullptr;
    KD_GL_FUNCTIONS(KD_GL_MEMBER)
#undef KD_GL_MEMBER

    /// Null where the driver does not tell: below OpenGL 4.5.
    PFNGLGETGRAPHICSRESETSTATUSPROC GetGraphicsResetStatus = nullptr;
    GlMessages* messages = nullptr;  // what the driver said, where it is asked to (renderer/gl/gl_debug.h)

    /// Fills the table from eglGetProcAddress, OSMesaGetProcAddress, glfwGetProcAddress or alike, and returns the names
    /// that were not found.
    [[nodiscard]] std::vector<std::string> load(const GetProc& get_proc);
};

}  // namespace kd
