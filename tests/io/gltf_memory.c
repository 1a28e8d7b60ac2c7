// SPDX-License-Identifier: MIT
// Why: tinygltf takes its memory from the C++ library, so an allocator that fails does not reach
// it. Here `new` itself fails, the k-th time and from then on, for every k: the reader must answer
// "no memory", leave nothing behind and throw nothing. Guards: the strong guarantee, issue 8
// part 2.

#include "gltf_files.h"

#ifdef TEST_HAS_NEW
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

#ifdef TEST_HAS_NEW
void new_fails_at(long k);
long new_live(void);

// In a process of its own: 0 when the mesh came, 1 when the answer was "no memory", 2 for another.
static int read_with_failing_new(const file *f, long k)
{
    sf_mesh *mesh = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    long before = new_live();
    new_fails_at(k);
    sf_status status = read_gltf(f->bytes, f->size, NULL, NULL, &mesh, NULL, &fault);
    new_fails_at(-1);
    int good = status == SF_OK || (status == SF_ERR_MEMORY && refused_well(status, &fault, mesh));
    if (!good) {
        printf("# new %ld: %s: %s\n", k, sf_status_name(status), fault.message);
    }
    sf_mesh_destroy(mesh);
    return !good || new_live() != before ? 2 : status != SF_OK;
}

static void answers_every_failing_new(void)
{
    static file f;
    int ended[3] = {0, 0, 0}, stopped = 0;
    make_plain_glb(&f, GLTF_HEAD GLTF_SCENE GLTF_NODE GLTF_MESH GLTF_VIEWS GLTF_LISTS
                   "\"materials\":[{\"name\":\"a name too long to stand in a string itself\"}],"
                   "\"extras\":{\"a\":[1,2,3]}," GLTF_BUFFER);
    for (long k = 0; ended[0] == 0 && k < 20000; k++) {
        int status = 0;
        fflush(NULL);
        pid_t child = fork();
        if (child == 0) {
            (void)!freopen("/dev/null", "w", stderr);
            int end = read_with_failing_new(&f, k);
            fflush(NULL);
            _exit(end);
        }
        CHECK(child > 0 && waitpid(child, &status, 0) == child);
        int is_stopped = WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT;
        CHECK(is_stopped || (WIFEXITED(status) && WEXITSTATUS(status) < 2));
        stopped += is_stopped;
        ended[WIFEXITED(status) ? WEXITSTATUS(status) % 3 : 2] += !is_stopped;
    }
    printf("# %d times no memory, %d times the JSON parser ended the process\n", ended[1], stopped);
    CHECK(ended[0] == 1 && ended[1] > 100 && stopped < ended[1] / 2);
}
#endif

int main(void)
{
#ifdef TEST_HAS_NEW
    TEST(answers_every_failing_new);
    return test_finish();
#else
    printf("1..0 # SKIP there is no `new` that could fail\n");
    return 0;
#endif
}
