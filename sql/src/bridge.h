/* What the C half (PostgreSQL's calls) and the C++ half (the library's calls) say to each other.
 *
 * PostgreSQL leaves a function by longjmp when it reports an error, and C++ by exceptions. Neither
 * may pass through the other's frames. So no C++ file includes PostgreSQL's headers, and no
 * exception leaves a function that is declared here. What C++ allocates belongs to a mink_state,
 * which a reset callback of a memory context frees. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* How a call ended. */
typedef enum mink_status {
  MINK_OK,
  MINK_NULL,       /* the answer is NULL */
  MINK_BAD_INPUT,  /* 22023 */
  MINK_BAD_BYTES,  /* 22P03: no WKB */
  MINK_BAD_TEXT,   /* 22P02: no WKT */
  MINK_LIMIT,      /* 54000 */
  MINK_MEMORY,     /* 53200 */
  MINK_CANCELLED,  /* whatever PostgreSQL says on interrupts */
  MINK_INTERNAL    /* XX000 */
} mink_status;

typedef struct mink_error {
  char message[1024];
  char detail[512];
  char hint[512];
} mink_error;

typedef struct mink_bytes {
  const char* data;
  size_t size;
} mink_bytes;

typedef enum mink_operation {
  MINK_SUM,
  MINK_ERODE,
  MINK_OPEN,
  MINK_CLOSE,
  MINK_UNION,
  MINK_INTERSECTION,
  MINK_DIFFERENCE,
  MINK_SYM_DIFFERENCE,
  MINK_RESOLVE,
  MINK_OFFSET,
  MINK_DISC,
  MINK_NO_FIT_POLYGON,
  MINK_INNER_FIT_POLYGON,
  MINK_DEPTH,
  MINK_IMPACT,
  MINK_IS_SUM
} mink_operation;

/* The arguments of a call. Words that were not given are empty. */
typedef struct mink_request {
  mink_operation operation;
  bool text; /* operands and answers are exact WKT; otherwise they are EWKB */
  const mink_bytes* operands;
  int operand_count;
  double numbers[4]; /* in the order of the arguments */
  int number_count;
  mink_bytes exact; /* a number as text, in place of numbers[0] */
  int whole;        /* a count: of angles, or of directions */
  bool wanted;      /* whether free space is wanted as well */
  mink_bytes fill;
  mink_bytes round;
  mink_bytes side;
  mink_bytes join;
  mink_bytes cap;
  uint64_t max_segments;
  uint64_t max_crossings;
  bool (*stop)(void); /* tells whether the computation has to end */
} mink_request;

/* What a call returns. Bytes belong to the state and last until its next call. */
typedef struct mink_answer {
  mink_bytes sets[2];
  bool truth;
  double numbers[3];
  int whole[4];
  mink_bytes exact;
  int prepared; /* how many operands this call prepared */
} mink_answer;

typedef struct mink_state mink_state;

mink_state* mink_state_new(void); /* NULL if memory runs out */
void mink_state_free(mink_state* state);

/* Computes one value. */
mink_status mink_compute(mink_state* state, const mink_request* request, mink_answer* answer,
                         mink_error* error);

/* Begin a set of rows and say how many there are. */
mink_status mink_begin_slices(mink_state* state, const mink_request* request, uint64_t* count,
                              mink_error* error);
mink_status mink_begin_no_fit_table(mink_state* state, const mink_request* request,
                                    uint64_t* count, mink_error* error);
/* Make one row of the set that was begun last. */
mink_status mink_slice(mink_state* state, uint64_t row, mink_answer* answer, mink_error* error);
mink_status mink_no_fit_entry(mink_state* state, uint64_t row, mink_answer* answer,
                              mink_error* error);

/* Aggregates: MINK_UNION and MINK_SUM. */
mink_status mink_collect(mink_state* state, const mink_request* request, mink_error* error);
mink_status mink_merge(mink_state* state, const mink_state* other, const mink_request* request,
                       mink_error* error);
mink_status mink_save(mink_state* state, const mink_request* request, mink_answer* answer,
                      mink_error* error);
mink_status mink_load(mink_state* state, mink_bytes saved, const mink_request* request,
                      mink_error* error);
mink_status mink_finish(mink_state* state, const mink_request* request, mink_answer* answer,
                        mink_error* error);

#ifdef __cplusplus
}
#endif
