// SPDX-License-Identifier: MIT
// Base of libsf: status codes, faults, memory, byte streams and long-running tasks.
//
// Everything that every other header needs and nothing else. Four ideas live here:
//
//   * A call that can fail returns an sf_status and changes nothing when it fails (the strong
//     guarantee). Where the reason lies in somebody's data, the call also takes an optional
//     sf_fault, which it fills with a sentence that says what is wrong, where, and what to do.
//   * Memory comes from an sf_allocator that the caller hands to whatever owns memory. There is no
//     global setter, and no call allocates behind the caller's back.
//   * Bytes come from an sf_source and go to an sf_sink. No reader or writer ever sees a path.
//   * Long work takes an sf_task: progress, a cancel that sticks, and the host's own threads.
//
// The names sf_open, sf_error, sf_strerror and their family belong to libsndfile; libsf takes none.

#ifndef SF_BASE_H
#define SF_BASE_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

// ---------------------------------------------------------------------------------------------
// Version and linkage
// ---------------------------------------------------------------------------------------------

/** Version of these headers: what breaks programs raises it. */
#define SF_VERSION_MAJOR 0
/** And what adds to them; before 1.0 it may break them as well. */
#define SF_VERSION_MINOR 1
/** And what mends them. */
#define SF_VERSION_PATCH 0
/** The three as one text, as sf_version() gives that of the library. */
#define SF_VERSION_STRING "0.1.0"

#if defined(SF_STATIC)
#define SF_API
#elif defined(_WIN32)
#if defined(SF_BUILDING)
#define SF_API __declspec(dllexport)
#else
#define SF_API __declspec(dllimport)
#endif
#elif defined(__GNUC__)
#define SF_API __attribute__((visibility("default")))
#else
#define SF_API
#endif

#if defined(__GNUC__)
#define SF_CHECKED __attribute__((warn_unused_result))
#else
#define SF_CHECKED
#endif

/**
 * Version of the library that is running, as "major.minor.patch".
 *
 * @return a static string, never NULL.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API const char *sf_version(void);

// ---------------------------------------------------------------------------------------------
// Status
// ---------------------------------------------------------------------------------------------

/**
 * What became of a call. Numbers are fixed and never reused.
 *
 * Anything but SF_OK changed no object and no output, with one exception: SF_ERR_CAPACITY may leave
 * the number of places needed in the call's count, where its comment says so. An sf_fault is there
 * to be filled, and a sink keeps the bytes that it has had.
 */
typedef enum sf_status {
    SF_OK = 0,              /**< done */
    SF_ERR_ARGUMENT = 1,    /**< a pointer is NULL or a value lies outside its documented range */
    SF_ERR_SHAPE = 2,       /**< two objects that must agree in size or lattice do not */
    SF_ERR_CAPACITY = 3,    /**< the caller's buffer is too small; the need was reported */
    SF_ERR_OVERFLOW = 4,    /**< a size does not fit the machine or the library's limits */
    SF_ERR_MEMORY = 5,      /**< the allocator returned NULL */
    SF_ERR_IO = 6,          /**< a source or sink failed */
    SF_ERR_FORMAT = 7,      /**< the bytes are not what the format allows */
    SF_ERR_UNSUPPORTED = 8, /**< well-formed, but not served by this rule, build or version */
    SF_ERR_CANCELLED = 9,   /**< the task was cancelled */
    SF_ERR_INTERNAL = 10,   /**< a promise of the library was broken: please report it */
    SF_ERR_INFEASIBLE = 11, /**< what must stay cannot be carried within what may be there */
    SF_STATUS_COUNT = 12    /**< number of codes, not a code */
} sf_status;

/**
 * Name of a status code, such as "SF_ERR_SHAPE".
 *
 * @param status  any value; one that is no code gives "SF_STATUS_UNKNOWN"
 * @return a static string, never NULL.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API const char *sf_status_name(sf_status status);

/**
 * One English sentence that explains a status code.
 *
 * @param status  any value
 * @return a static string, never NULL.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API const char *sf_status_message(sf_status status);

/** Size of the sentence in an sf_fault, its final zero included, in bytes. */
#define SF_FAULT_MESSAGE_SIZE 232

/** Why a call failed, in words for the person whose data it was. Filled only on failure. */
typedef struct sf_fault {
    sf_status status; /**< the code that the call returned */
    uint32_t line;    /**< line in a text file, counted from 1; 0 where it does not apply */
    uint64_t offset;  /**< byte offset in a file, counted from 0; 0 where it does not apply */
    char message[SF_FAULT_MESSAGE_SIZE]; /**< what is wrong, where, and what to do; UTF-8 */
} sf_fault;

// ---------------------------------------------------------------------------------------------
// Memory
// ---------------------------------------------------------------------------------------------

/**
 * Where an owner takes its memory from. A NULL allocator argument means the C library's.
 *
 * `alloc` returns `size` bytes aligned to `align` (a power of two), or NULL; `size` is never 0.
 * `free` gets the same size back; its pointer is never NULL. Both may be called from the thread
 * that calls the library, and from no other. The struct is copied by owners; `user` must outlive
 * them.
 *
 * An allocator serves one thread at a time: of the calls that take it, or that change or destroy an
 * owner made with it, one may run at a time, unless its functions lock. The C library's do.
 */
typedef struct sf_allocator {
    void *(*alloc)(void *user, size_t size, size_t align); /**< returns memory, or NULL */
    void (*free)(void *user, void *memory, size_t size);   /**< takes it back */
    void *user;                                            /**< handed to both; may be NULL */
} sf_allocator;

// ---------------------------------------------------------------------------------------------
// Byte streams
// ---------------------------------------------------------------------------------------------

/**
 * Where bytes come from.
 *
 * `read` stores up to `capacity` bytes (at least 1 is asked for) and their number in `size`; 0
 * bytes with SF_OK means the end. Short reads are fine. A status other than SF_OK is passed on
 * unchanged; a source that claims more than `capacity` is taken for one that failed, SF_ERR_IO.
 */
typedef struct sf_source {
    sf_status (*read)(void *user, void *data, size_t capacity,
                      size_t *size); /**< stores the next bytes */
    void *user;                      /**< handed to it; may be NULL */
} sf_source;

/** Where bytes go. `write` takes all `size` bytes or returns a status, which is passed on
 * unchanged. */
typedef struct sf_sink {
    sf_status (*write)(void *user, const void *data, size_t size); /**< takes bytes */
    void *user;                                                    /**< handed to it; may be NULL */
} sf_sink;

/** Bytes in memory, read front to back; the state behind sf_memory_source. */
typedef struct sf_memory_cursor {
    const void *data; /**< first byte; may be NULL where size is 0 */
    size_t size;      /**< number of bytes */
    size_t position;  /**< bytes already read; beyond `size` it is at the end */
} sf_memory_cursor;

/**
 * A source that reads from memory.
 *
 * @param cursor  data, size and position, not NULL; must outlive the source; position advances with
 *                each read
 * @return the source.
 * @cost constant.   @threads any, on distinct cursors.
 * @since 0.1
 */
SF_API sf_source sf_memory_source(sf_memory_cursor *cursor);

// ---------------------------------------------------------------------------------------------
// Tasks
// ---------------------------------------------------------------------------------------------

/** One piece of parallel work: called once for each index, from any thread of the host. */
typedef void (*sf_task_body)(void *context, size_t index);

/**
 * How long work talks to its host. Make one with sf_task_default(), fill in what you need.
 *
 * `progress` is called on the thread that called the library, with a fraction in [0, 1] that never
 * falls during one call. `parallel_for` must call `body(context, i)` once for each i in [0, count),
 * in any order and on any threads, and return when all are done; NULL runs them one after the
 * other. Results are the same bytes either way.
 */
typedef struct sf_task {
    size_t struct_size;                            /**< sizeof(sf_task), set by sf_task_default() */
    void (*progress)(void *user, double fraction); /**< may be NULL */
    void (*parallel_for)(void *user, size_t count, sf_task_body body,
                         void *context); /**< or NULL */
    void *user;                          /**< handed to both callbacks; may be NULL */
    int cancel_state;            /**< private: use sf_task_cancel() and sf_task_is_cancelled() */
    const struct sf_task *whole; /**< private: NULL */
} sf_task;

/**
 * A task without callbacks, not cancelled.
 *
 * @return the task, by value.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_task sf_task_default(void);

/**
 * Ask a task to stop. The request sticks: every later call with this task is cancelled too.
 *
 * @param task  the task; NULL does nothing
 * @cost constant.   @threads any, while the task is in use.
 * @since 0.1
 */
SF_API void sf_task_cancel(sf_task *task);

/**
 * Whether a task has been cancelled.
 *
 * @param task  the task; NULL counts as never cancelled
 * @return 1 if cancelled, else 0.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API int sf_task_is_cancelled(const sf_task *task);

#ifdef __cplusplus
}
#endif

#endif
