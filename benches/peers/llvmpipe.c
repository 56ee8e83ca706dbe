/* Draws a workload by Mesa's llvmpipe, into memory, and times it.
 *
 * The benchmark `peers` compiles this with `cc -O2 llvmpipe.c -lEGL -lGL`, starts it with GALLIUM_DRIVER=llvmpipe
 * LIBGL_ALWAYS_SOFTWARE=1 LP_NUM_THREADS=n, and talks to it through pipes, in the machine's own byte order:
 *
 *   in    struct header, then the vertices, then the indices (none: triangles in order)
 *   out   a line "GL_RENDERER | GL_VERSION\n", or "error: ...\n" and an exit status of 1
 *   in    'F', u32 n       draw n frames
 *   out   u64 per frame    nanoseconds from before glClear to after glFinish
 *   in    'P'              the picture
 *   out   u32 per pixel    0x00RRGGBB, rows from top to bottom
 *
 * Depth is a 32-bit float, reversed: cleared to 0, GL_GREATER, clip control from zero to one. */

#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

struct header {
    uint32_t lit;        /* 0: the number of the triangle plus one is its colour; 1: a mesh in one colour, lit */
    uint32_t width, height;
    uint32_t vertices;
    uint32_t components; /* of a vertex: 4 (in clip space), 3 (to be multiplied by the matrix), 6 (and its normal) */
    uint32_t indices;
    uint32_t cull;       /* 1: back faces are left out */
    float matrix[16];    /* by columns */
    float light[4];      /* towards the light, in model space; the share of ambient light */
    float color[4];      /* linear */
};

static void fail(const char *what) {
    printf("error: %s (EGL 0x%x)\n", what, (unsigned)eglGetError());
    exit(1);
}

static void take(void *to, size_t bytes) {
    if (fread(to, 1, bytes, stdin) != bytes) exit(0); /* the other side has gone */
}

static void *take_new(size_t bytes) {
    void *memory = malloc(bytes ? bytes : 1);
    if (!memory) fail("no memory for the workload");
    take(memory, bytes);
    return memory;
}

static void make_context(void) {
    EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
    if (!display || !eglInitialize(display, NULL, NULL)) fail("no surfaceless EGL display");
    if (!eglBindAPI(EGL_OPENGL_API)) fail("no OpenGL by EGL");
    const EGLint any[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config;
    EGLint count;
    if (!eglChooseConfig(display, any, &config, 1, &count) || count < 1) fail("no EGL configuration");
    const EGLint core[] = {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 5,
                           EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, core);
    if (!context) fail("no OpenGL 4.5 core context");
    if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) fail("no context without a surface");
}

static GLuint shader(GLenum kind, const char *text) {
    GLuint name = glCreateShader(kind);
    GLint good;
    glShaderSource(name, 1, &text, NULL);
    glCompileShader(name);
    glGetShaderiv(name, GL_COMPILE_STATUS, &good);
    if (!good) {
        char log[1024] = "";
        glGetShaderInfoLog(name, sizeof log, NULL, log);
        fprintf(stderr, "%s\n", log);
        fail("a shader does not compile");
    }
    return name;
}

static const char clip_vertex[] =
    "#version 330 core\n"
    "layout(location = 0) in vec4 place;\n"
    "void main() { gl_Position = place; }\n";

static const char model_vertex[] =
    "#version 330 core\n"
    "layout(location = 0) in vec3 place;\n"
    "uniform mat4 matrix;\n"
    "void main() { gl_Position = matrix * vec4(place, 1.0); }\n";

static const char number_fragment[] =
    "#version 330 core\n"
    "out vec4 pixel;\n"
    "void main() {\n"
    "    uint id = uint(gl_PrimitiveID) + 1u;\n"
    "    pixel = vec4(uvec4(id >> 16, (id >> 8) & 255u, id & 255u, 0u)) / 255.0;\n"
    "}\n";

/* A face's normal is an attribute of its last vertex, the one whose flat outputs count. Light and encoding are then
 * done once a vertex, and nothing is left to do for a pixel. */
static const char lit_vertex[] =
    "#version 330 core\n"
    "layout(location = 0) in vec3 place;\n"
    "layout(location = 1) in vec3 normal;\n"
    "uniform mat4 matrix;\n"
    "uniform vec4 light;\n"
    "uniform vec4 color;\n"
    "flat out vec4 shade;\n"
    "void main() {\n"
    "    float direct = max(dot(normal, light.xyz), 0.0);\n"
    "    vec3 x = color.rgb * (light.w + (1.0 - light.w) * direct);\n"
    "    vec3 high = 1.055 * pow(x, vec3(1.0 / 2.4)) - 0.055;\n"
    "    shade = vec4(mix(high, 12.92 * x, lessThanEqual(x, vec3(0.0031308))), 0.0);\n"
    "    gl_Position = matrix * vec4(place, 1.0);\n"
    "}\n";

static const char lit_fragment[] =
    "#version 330 core\n"
    "flat in vec4 shade;\n"
    "out vec4 pixel;\n"
    "void main() { pixel = shade; }\n";

static void make_program(const struct header *h) {
    const char *vertex = h->components == 4 ? clip_vertex : h->lit ? lit_vertex : model_vertex;
    GLuint program = glCreateProgram();
    GLint good;
    glAttachShader(program, shader(GL_VERTEX_SHADER, vertex));
    glAttachShader(program, shader(GL_FRAGMENT_SHADER, h->lit ? lit_fragment : number_fragment));
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &good);
    if (!good) fail("the program does not link");
    glUseProgram(program);
    glUniformMatrix4fv(glGetUniformLocation(program, "matrix"), 1, GL_FALSE, h->matrix);
    glUniform4fv(glGetUniformLocation(program, "light"), 1, h->light);
    glUniform4fv(glGetUniformLocation(program, "color"), 1, h->color);
    glGetError(); /* a soup has no such uniforms */
}

static void make_target(const struct header *h) {
    GLuint names[2], target;
    glGenRenderbuffers(2, names);
    glBindRenderbuffer(GL_RENDERBUFFER, names[0]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, h->width, h->height);
    glBindRenderbuffer(GL_RENDERBUFFER, names[1]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, h->width, h->height);
    glGenFramebuffers(1, &target);
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, names[0]);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, names[1]);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) fail("no framebuffer");
    glViewport(0, 0, h->width, h->height);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glClearDepth(0.0);
    glClearColor(0, 0, 0, 0);
    if (h->cull) glEnable(GL_CULL_FACE);
}

static void make_buffers(const struct header *h) {
    size_t vertex_bytes = (size_t)h->vertices * h->components * sizeof(float);
    size_t index_bytes = (size_t)h->indices * sizeof(uint32_t);
    void *vertices = take_new(vertex_bytes), *indices = take_new(index_bytes);
    GLuint array, buffers[2];
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glGenBuffers(2, buffers);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glBufferData(GL_ARRAY_BUFFER, vertex_bytes, vertices, GL_STATIC_DRAW);
    glEnableVertexAttribArray(0);
    GLsizei stride = h->components * sizeof(float);
    glVertexAttribPointer(0, h->lit ? 3 : h->components, GL_FLOAT, GL_FALSE, stride, NULL);
    if (h->lit) {
        glEnableVertexAttribArray(1);
        glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, stride, (const void *)(3 * sizeof(float)));
    }
    if (h->indices) {
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, index_bytes, indices, GL_STATIC_DRAW);
    }
    free(vertices);
    free(indices);
}

static uint64_t now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (uint64_t)t.tv_sec * 1000000000u + (uint64_t)t.tv_nsec;
}

static uint64_t frame(const struct header *h) {
    uint64_t start = now();
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    if (h->indices) {
        glDrawElements(GL_TRIANGLES, h->indices, GL_UNSIGNED_INT, NULL);
    } else {
        glDrawArrays(GL_TRIANGLES, 0, h->vertices);
    }
    glFinish();
    return now() - start;
}

static void picture(const struct header *h) {
    size_t row = (size_t)h->width, rows = h->height;
    uint8_t *pixels = malloc(4 * row * rows);
    uint32_t *line = malloc(sizeof(uint32_t) * row);
    if (!pixels || !line) exit(1);
    glReadPixels(0, 0, h->width, h->height, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    for (size_t y = rows; y-- > 0;) {
        for (size_t x = 0; x < row; x++) {
            const uint8_t *p = pixels + 4 * (y * row + x);
            line[x] = (uint32_t)p[0] << 16 | (uint32_t)p[1] << 8 | p[2];
        }
        fwrite(line, sizeof(uint32_t), row, stdout);
    }
    free(pixels);
    free(line);
}

int main(void) {
    struct header h;
    take(&h, sizeof h);
    make_context();
    make_target(&h);
    make_program(&h);
    make_buffers(&h);
    if (glGetError() != GL_NO_ERROR) fail("OpenGL refuses the workload");
    printf("%s | %s\n", glGetString(GL_RENDERER), glGetString(GL_VERSION));
    fflush(stdout);
    for (;;) {
        char command;
        take(&command, 1);
        if (command == 'F') {
            uint32_t frames;
            take(&frames, sizeof frames);
            while (frames--) {
                uint64_t ns = frame(&h);
                fwrite(&ns, sizeof ns, 1, stdout);
            }
        } else if (command == 'P') {
            picture(&h);
        } else {
            fail("a command that is none");
        }
        fflush(stdout);
    }
}
