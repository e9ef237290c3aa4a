//! A queue of bounded length that returns the most urgent job first, and jobs of equal urgency in the order of
//! arrival.

use bessemer::prelude::*;

/// A job and its urgency.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Job {
    pub urgency: u8,
    pub number: u16,
}

/// The jobs in order, the most urgent last.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Queue {
    jobs: List<Job, 6>,
}

#[component]
impl Queue {
    /// Adds a job; returns false if the queue is full.
    #[entry]
    pub fn put(&mut self, job: Job) -> bool {
        if self.jobs.len() == 6 {
            return false;
        }
        self.jobs.push(job);
        let mut at = self.jobs.len() - 1;
        #[bound(6)]
        while at > 0 && self.jobs[at - 1].urgency >= job.urgency {
            self.jobs[at] = self.jobs[at - 1];
            at -= 1;
        }
        self.jobs[at] = job;
        true
    }

    /// Removes and returns the most urgent job.
    #[entry(infallible)]
    pub fn take(&mut self) -> Option<Job> {
        self.jobs.pop()
    }
}
