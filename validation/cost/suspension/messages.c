/* Counts what a rank sends: loaded before MPI, prints at the end of the run
       messages <rank> <sent> <bytes> <collective operations> <of the sent ones, in trees>
           <largest memory, MB>
   Sent are MPI_Send, MPI_Bsend and MPI_Isend, collective MPI_Allreduce and MPI_Alltoall, which are
   those that OpenFOAM calls in a step. OpenFOAM sends by MPI_Send what it gathers and scatters along
   a tree of the ranks, and by the others what goes to neighbours. MPI's profiling interface (MPI
   standard, chapter "Profiling Interface") gives every function a second name with the prefix P. */
#include <mpi.h>
#include <stdio.h>
#include <sys/resource.h>

static long long sent, bytes, collective, trees;

static void count(int n, MPI_Datatype type)
{
    int size;
    PMPI_Type_size(type, &size);
    ++sent;
    bytes += (long long)n*size;
}

int MPI_Send(const void* p, int n, MPI_Datatype t, int to, int tag, MPI_Comm c)
{
    count(n, t);
    ++trees;
    return PMPI_Send(p, n, t, to, tag, c);
}

int MPI_Bsend(const void* p, int n, MPI_Datatype t, int to, int tag, MPI_Comm c)
{
    count(n, t);
    return PMPI_Bsend(p, n, t, to, tag, c);
}

int MPI_Isend
(
    const void* p, int n, MPI_Datatype t, int to, int tag, MPI_Comm c, MPI_Request* r
)
{
    count(n, t);
    return PMPI_Isend(p, n, t, to, tag, c, r);
}

int MPI_Allreduce
(
    const void* p, void* q, int n, MPI_Datatype t, MPI_Op op, MPI_Comm c
)
{
    ++collective;
    return PMPI_Allreduce(p, q, n, t, op, c);
}

int MPI_Alltoall
(
    const void* p, int n, MPI_Datatype t, void* q, int m, MPI_Datatype u, MPI_Comm c
)
{
    ++collective;
    return PMPI_Alltoall(p, n, t, q, m, u, c);
}

int MPI_Finalize(void)
{
    int rank;
    struct rusage usage;
    PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
    getrusage(RUSAGE_SELF, &usage);
    fprintf
    (
        stderr, "messages %d %lld %lld %lld %lld %ld\n",
        rank, sent, bytes, collective, trees, usage.ru_maxrss/1024
    );
    return PMPI_Finalize();
}
